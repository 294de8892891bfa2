#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pongsim/math.hh"
#include "support/rendering/drawn_world.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using ShadowMaps = test::Pictures;

/// A white ground with a pillar and a plate above it, under the sun and a spot. The plate is model 2.
std::unique_ptr<DrawnWorld> shadedWorld() {
  auto world = std::make_unique<DrawnWorld>();
  const auto addWhite = [&world](const description::Geometry& geometry, const Vector3& position) {
    auto& material = *world->addShining(geometry, position, {}).material;
    material.isLit = true;
    material.diffuse = {1, 1, 1, 1};
  };
  addWhite(description::Plane{Vector3::UnitZ(), {40, 40}}, {0, 0, 0});
  addWhite(description::Cylinder{0.2, 3}, {1, 2, 1.5});
  addWhite(description::Box{{1, 1, 0.1}}, {0, 0, 1});
  for (const auto type : {description::LightType::kDirectional, description::LightType::kSpot}) {
    description::Light& light = world->description().lights.emplace_back();
    light.name = "lamp" + std::to_string(world->description().lights.size());
    light.type = type;
    light.castsShadows = true;
    light.direction = Vector3(0.2, 0.1, -1).normalized();
    light.X_ParentLight.position = {-1, 0, 5};
    light.linearAttenuation = 0;
    light.outerAngle = 1.4;
    light.innerAngle = 1.3;
    light.diffuse = {0.5F, 0.5F, 0.5F, 1};
  }
  return world;
}

PictureView fromAbove(std::uint32_t width, std::uint32_t height) {
  PictureView eye = test::view(width, height, width);
  eye.X_WorldEye = {{-4, -1, 3}, fromRollPitchYaw(0, 0.6, 0.2)};
  return eye;
}

TEST_F(ShadowMaps, AreThoseOfAFirstPictureHoweverThingsHaveMoved) {
  const std::unique_ptr<DrawnWorld> world = shadedWorld();
  world->start();
  PictureView eye = fromAbove(160, 120);
  std::vector<std::uint8_t> before = world->colors(eye);
  // a little, onto the pillar's shadow, out of the light, and back
  for (const Vector3& place :
       {Vector3(0.01, 0, 1), Vector3(0.8, 1.8, 1), Vector3(0.8, 1.8, 2), Vector3(30, 0, 1), Vector3(0, 0, 1)}) {
    world->move(2, place);
    const std::vector<std::uint8_t> kept = world->colors(eye);
    EXPECT_NE(kept, before) << place.transpose();
    EXPECT_EQ(kept, world->colorsAnew(eye)) << place.transpose();
    before = kept;
    // another camera, which has other maps, in between
    eye.X_WorldEye.position.y() += 0.1;
    EXPECT_EQ(world->colors(fromAbove(640, 480)).size(), std::size_t{3} * 640 * 480);
  }
}

TEST_F(ShadowMaps, AreTheSameForAllCameras) {
  const std::unique_ptr<DrawnWorld> world = shadedWorld();
  world->start();
  const PictureView first = fromAbove(160, 120);
  PictureView second = first;
  second.X_WorldEye = {{3, 3, 2}, fromRollPitchYaw(0, 0.5, -2.4)};
  // each after the other
  const std::vector<std::uint8_t> alone = world->colors(second);
  world->move(2, {0.3, 0, 1});
  const std::vector<std::uint8_t> ofFirst = world->colors(first), ofSecond = world->colors(second);
  EXPECT_NE(ofSecond, alone);
  EXPECT_EQ(ofSecond, world->colorsAnew(second));
  EXPECT_EQ(ofFirst, world->colors(first));
}

TEST_F(ShadowMaps, FollowLampsThatAreSwitchedOff) {
  const std::unique_ptr<DrawnWorld> world = shadedWorld();
  world->start();
  const PictureView eye = fromAbove(160, 120);
  const std::vector<std::uint8_t> lit = world->colors(eye);
  world->description().lights[0].isOn = false;
  world->letPass({});
  EXPECT_NE(world->colors(eye), lit);
  EXPECT_EQ(world->colors(eye), world->colorsAnew(eye));
  world->description().lights[0].isOn = true;
  world->letPass({});
  EXPECT_EQ(world->colors(eye), lit);
}

}  // namespace
}  // namespace pongsim::rendering
