#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "assets/picture_file.hh"
#include "pongsim/camera_scene.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

/// Each shape, in colours, as metal and half transparent, under the sun and a spot.
constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w">
  <scene><ambient>0.6 0.6 0.6 1</ambient><background>0.4 0.6 0.9 1</background></scene>
  <light name="sun" type="directional"><cast_shadows>true</cast_shadows><diffuse>0.7 0.7 0.7 1</diffuse>
    <specular>0.3 0.3 0.3 1</specular><direction>0.4 0.3 -0.9</direction></light>
  <light name="spot" type="spot"><pose>1 -3 3 0 0 0</pose><cast_shadows>true</cast_shadows><diffuse>0.9 0.5 0.1 1</diffuse>
    <attenuation><range>20</range><constant>1</constant><linear>0</linear></attenuation>
    <spot><inner_angle>0.7</inner_angle><outer_angle>0.8</outer_angle><falloff>1</falloff></spot></light>
  <model name="m"><static>true</static><link name="l">
    <visual name="ground"><geometry><plane><size>12 12</size></plane></geometry>
      <material><diffuse>0.6 0.6 0.6 1</diffuse></material></visual>
    <visual name="box"><pose>0 0 0.5 0 0 0.5</pose><geometry><box><size>1 1 1</size></box></geometry>
      <material><diffuse>0.8 0.1 0.1 1</diffuse><specular>0.5 0.5 0.5 1</specular></material></visual>
    <visual name="ball"><pose>0 2 0.6 0 0 0</pose><geometry><sphere><radius>0.6</radius></sphere></geometry>
      <material><diffuse>0.8 0.7 0.3 1</diffuse><pbr><metal><metalness>0.9</metalness><roughness>0.3</roughness></metal></pbr>
      </material></visual>
    <visual name="column"><pose>2 1 1 0 0 0</pose><geometry><cylinder><radius>0.3</radius><length>2</length></cylinder></geometry>
      <material><diffuse>0.1 0.6 0.2 1</diffuse></material></visual>
    <visual name="egg"><pose>1 -2 0.7 0 0 0</pose><geometry><ellipsoid><radii>0.4 0.5 0.7</radii></ellipsoid></geometry></visual>
    <visual name="pill"><pose>-1.5 -1 0.3 0 1.57 0.8</pose><geometry><capsule><radius>0.3</radius><length>0.8</length></capsule></geometry>
      <transparency>0.5</transparency><material><diffuse>0.1 0.2 0.9 1</diffuse></material></visual>
  </link></model></world></sdf>)";

/// How much two pictures differ, as somebody sees it who looks at them from some way off: four by four pixels at a
/// time, so that other roundings along edges do not count.
/// @return The largest difference of a block's colour, of 255.
int largestDifference(const std::vector<std::uint8_t>& drawn, const assets::Picture& golden) {
  constexpr std::size_t kBlock = 4;
  int largest = 0;
  for (std::size_t row = 0; row + kBlock <= golden.height; row += kBlock) {
    for (std::size_t column = 0; column + kBlock <= golden.width; column += kBlock) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        int difference = 0;
        for (std::size_t i = 0; i < kBlock * kBlock; ++i) {
          const std::size_t pixel = (row + i / kBlock) * golden.width + column + i % kBlock;
          difference += drawn[3 * pixel + channel] - golden.pixels[4 * pixel + channel];
        }
        largest = std::max(largest, std::abs(difference) / static_cast<int>(kBlock * kBlock));
      }
    }
  }
  return largest;
}

TEST(Picture, LooksAsItDid) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(kWorld, "world.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  std::unique_ptr<CameraScene> scene;
  try {
    scene = std::make_unique<CameraScene>(simulation->world());
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  scene->rebuild(diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  PictureView view;
  view.X_WorldEye = {{-5, -2, 3}, fromRollPitchYaw(0, 0.45, 0.4)};
  view.width = 160;
  view.height = 120;
  view.fx = view.fy = 140;
  view.cx = 80;
  view.cy = 60;
  std::vector<std::uint8_t> pixels(std::size_t{3} * view.width * view.height);
  scene->drawColors(view, pixels);

  const std::filesystem::path file = projectFolder() / "test/golden/pictures/shapes.png";
  if (std::getenv("PONGSIM_WRITE_GOLDEN") != nullptr) {
    CameraScene::writePicture(file, view.width, view.height, pixels);
    return;
  }
  const auto read = assets::readPicture(file);
  const auto* golden = std::get_if<assets::Picture>(&read);
  ASSERT_NE(golden, nullptr);
  ASSERT_EQ(golden->width, view.width);
  ASSERT_EQ(golden->height, view.height);
  EXPECT_LE(largestDifference(pixels, *golden), 6);
}

}  // namespace
}  // namespace pongsim::test
