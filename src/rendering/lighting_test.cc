#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

}  // namespace
}  // namespace pongsim::rendering
