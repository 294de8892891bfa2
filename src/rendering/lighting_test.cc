#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

#include "pongsim/math.hh"
#include "support/rendering/drawn_world.hh"

namespace pongsim::rendering {
namespace {

using Fogs = test::Pictures;
using FogType = description::Fog::Type;

/// @return Red of a red wall at a distance in blue fog, as linear light, 0 to 1.
double redInFog(const description::Fog& fog, double distance) {
  test::DrawnWorld world;
  world.addShining(description::Box{{1, 9, 9}}, {distance + 0.5, 0, 0}, {1, 0, 0, 1});
  world.description().scene.fog = fog;
  world.start();
  const double shown = world.colors(test::view(9, 9, 9))[std::size_t{3} * 40] / 255.0;
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

description::Fog blueFog(FogType type, double density) {
  return {.type = type, .color = {0, 0, 1, 1}, .start = 2, .end = 12, .density = density};
}

TEST_F(Fogs, HideByTheirFormulas) {
  for (const double d : {1.0, 4.0, 7.0, 11.0, 15.0}) {
    EXPECT_EQ(redInFog(blueFog(FogType::kNone, 1), d), 1) << d;
    EXPECT_NEAR(redInFog(blueFog(FogType::kLinear, 0.8), d), 1 - 0.8 * std::clamp((d - 2) / 10, 0.0, 1.0), 0.01) << d;
    EXPECT_NEAR(redInFog(blueFog(FogType::kConstant, 0.1), d), std::exp(-0.1 * d), 0.01) << d;
    EXPECT_NEAR(redInFog(blueFog(FogType::kQuadratic, 0.1), d), std::exp(-0.01 * d * d), 0.01) << d;
  }
}

TEST_F(Fogs, HaveTheirColourFarAway) {
  test::DrawnWorld world;
  world.addShining(description::Box{{1, 900, 900}}, {90.5, 0, 0}, {1, 0, 0, 1});
  world.description().scene.fog = blueFog(FogType::kLinear, 1);
  world.start();
  const auto pixels = world.colors(test::view(9, 9, 9));
  EXPECT_EQ(pixels[std::size_t{3} * 40], 0);
  EXPECT_EQ(pixels[std::size_t{3} * 40 + 2], 255);
}

using Skies = test::Pictures;

constexpr std::uint32_t kSkyEdge = 41;

/// A world with nothing but a sky with small clouds, which move along y by 0.25 of their height in 50 s.
std::unique_ptr<test::DrawnWorld> cloudyWorld(double humidity) {
  auto world = std::make_unique<test::DrawnWorld>();
  world->description().scene.sky = description::Sky{
      .cloudSpeed = 0.5, .cloudDirection = std::numbers::pi / 2, .humidity = humidity, .cloudSize = 0.2};
  world->start();
  return world;
}

std::vector<std::uint8_t> zenithOf(test::DrawnWorld& world) {
  PictureView up = test::view(kSkyEdge, kSkyEdge, 40);
  up.X_WorldEye.rotation = fromRollPitchYaw(0, -std::numbers::pi / 2, 0);
  return world.colors(up);
}

double meanOf(const std::vector<std::uint8_t>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// @return The mean difference between a picture and another one whose columns are moved.
double differenceOf(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, std::size_t columns) {
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < kSkyEdge; ++row) {
    for (std::size_t i = 0; i < 3 * (kSkyEdge - columns); ++i, ++count) {
      sum += std::abs(a[3 * row * kSkyEdge + i] - b[3 * (row * kSkyEdge + columns) + i]);
    }
  }
  return sum / count;
}

TEST_F(Skies, HaveCloudsThatMoveWithTheWind) {
  const auto world = cloudyWorld(0.5);
  const auto before = zenithOf(*world);
  world->letPass(std::chrono::seconds(50));
  const auto after = zenithOf(*world);
  // y is to the left, so that what is 10 pixels farther left has been where a
  // pixel is
  EXPECT_LT(differenceOf(after, before, 10), 2);
  EXPECT_GT(differenceOf(after, before, 0), 8);
}

TEST_F(Skies, AreClearWithoutHumidityAndCoveredWithAllOfIt) {
  const auto clear = cloudyWorld(0);
  const auto before = zenithOf(*clear);
  clear->letPass(std::chrono::seconds(50));
  EXPECT_EQ(zenithOf(*clear), before);
  const double some = meanOf(zenithOf(*cloudyWorld(0.5))), most = meanOf(zenithOf(*cloudyWorld(1)));
  EXPECT_GT(some, meanOf(before) + 5);
  EXPECT_GT(most, some + 20);
  // as bright as the clouds' colour, 0.8
  EXPECT_NEAR(most, 204, 6);
}

}  // namespace
}  // namespace pongsim::rendering
