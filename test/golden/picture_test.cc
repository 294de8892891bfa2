#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "assets/images/picture_file.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

/// Each shape with plain, metallic and half transparent materials, under the sun and a spot light.
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

/// Compares two images in blocks of four by four pixels, so that rounding along edges does not matter.
/// @return The largest difference of a block's colour, 0 to 255.
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

/// Renders a world and compares it with the image of this name in test/golden/pictures. Skips without a renderer.
void expectToLookAsItDid(const std::string& world, const std::string& name) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(world, "world.sdf", {.loadSystems = false}, diagnostics);
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

  const std::filesystem::path file = projectFolder() / "test/golden/pictures" / name;
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

TEST(Picture, LooksAsItDid) { expectToLookAsItDid(kWorld, "shapes.png"); }

/// Writes a square image. `shares` gives the colour at a position, 0 to 1 from the left and from the top.
void writeSquare(const std::filesystem::path& file, const std::function<Vector3(double, double)>& shares) {
  constexpr std::uint32_t kEdge = 64;
  std::vector<std::uint8_t> pixels;
  for (std::uint32_t row = 0; row < kEdge; ++row) {
    for (std::uint32_t column = 0; column < kEdge; ++column) {
      const Vector3 color = shares((column + 0.5) / kEdge, (row + 0.5) / kEdge);
      for (const double share : color) pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
  CameraScene::writePicture(file, kEdge, kEdge, pixels);
}

/// A textured ball, box and column: rows of bumps from a normal map, smooth stripes, metallic squares, glowing spots.
TEST(Picture, OfMapsLooksAsItDid) {
  const TempFolder folder;
  const auto at = [&folder](const std::string& name) { return folder.path() / name; };
  const double turn = 2 * std::numbers::pi;
  writeSquare(at("normals.png"), [turn](double x, double y) {
    // waves with a length of a sixth of the image
    const Vector3 normal(-std::cos(6 * turn * x), std::cos(6 * turn * y), 1.2);
    return Vector3((normal.normalized() + Vector3::Ones()) / 2);
  });
  writeSquare(at("roughness.png"),
              [](double x, double) { return Vector3::Constant(std::fmod(4 * x, 1) < 0.5 ? 0.2 : 1); });
  writeSquare(at("metal.png"), [](double x, double y) {
    return Vector3::Constant((std::fmod(4 * x, 1) < 0.5) == (std::fmod(4 * y, 1) < 0.5) ? 1 : 0);
  });
  writeSquare(at("glow.png"), [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.5) < 0.2 ? Vector3(1, 0.5, 0) : Vector3(0, 0, 0);
  });
  const auto painted = [&](const std::string& name, const std::string& pose, const std::string& geometry,
                           const std::string& maps) {
    return "<visual name='" + name + "'><pose>" + pose + "</pose><geometry>" + geometry +
           "</geometry><material><diffuse>0.8 0.8 0.8 1</diffuse><specular>1 1 1 1</specular><pbr><metal>" + maps +
           "</metal></pbr></material></visual>";
  };
  const auto map = [&](const std::string& kind, const std::string& name) {
    return "<" + kind + "_map>" + at(name).string() + "</" + kind + "_map>";
  };
  const std::string numbers = "<roughness>1</roughness><metalness>1</metalness>";
  const std::string world =
      "<sdf version='1.9'><world name='w'><scene><ambient>0.5 0.5 0.5 1</ambient>"
      "<background>0.4 0.6 0.9 1</background></scene><light name='sun' type='directional'>"
      "<cast_shadows>true</cast_shadows><diffuse>0.7 0.7 0.7 1</diffuse><specular>0.5 0.5 0.5 1</specular>"
      "<direction>0.5 0.6 -0.8</direction></light><model name='m'><static>true</static><link name='l'>" +
      painted("ground", "0 0 0 0 0 0", "<plane><size>12 12</size></plane>",
              "<metalness>0</metalness>" + map("roughness", "roughness.png")) +
      painted("box", "0 0 0.6 0 0 0.5", "<box><size>1.2 1.2 1.2</size></box>",
              "<metalness>0</metalness>" + map("normal", "normals.png")) +
      painted("ball", "0 2 0.8 0 0 0", "<sphere><radius>0.8</radius></sphere>",
              numbers + map("metalness", "metal.png") + map("roughness", "roughness.png")) +
      painted("column", "1 -1.6 0.8 0 0 0", "<cylinder><radius>0.5</radius><length>1.6</length></cylinder>",
              "<metalness>0</metalness>" + map("normal", "normals.png") + map("emissive", "glow.png")) +
      "</link></model></world></sdf>";
  expectToLookAsItDid(world, "maps.png");
}

}  // namespace
}  // namespace pongsim::test
