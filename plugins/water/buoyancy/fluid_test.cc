#include "fluid.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace pongsim::fluid_test {
namespace {

constexpr double kPi = std::numbers::pi;

Fluid sea() {
  Fluid fluid(1000);
  fluid.addLayer(0, 1);
  return fluid;
}

TEST(Fluid, IsTheSameEverywhereWithoutLayers) {
  EXPECT_EQ(Fluid(800).densityBetween(-1e9, 1e9), 800);
  const Displaced displaced = Fluid(800).displacedBy(Solid(SphereShape{1}), Quaternion::Identity(), 3);
  EXPECT_NEAR(displaced.mass, 800 * kPi * 4 / 3, 1e-9);
  EXPECT_NEAR(displaced.first.norm(), 0, 1e-12);
}

TEST(Fluid, KnowsWhichLayerAHeightIsIn) {
  Fluid fluid = sea();
  EXPECT_FALSE(fluid.addLayer(0, 1.2));
  EXPECT_TRUE(fluid.addLayer(-10, 1020));
  EXPECT_EQ(fluid.densityBetween(-30, -10), 1000);
  EXPECT_EQ(fluid.densityBetween(-9, -1), 1020);
  EXPECT_EQ(fluid.densityBetween(0, 5), 1.2);
  EXPECT_FALSE(fluid.densityBetween(-1, 1).has_value());
  EXPECT_FALSE(fluid.densityBetween(-20, 1).has_value());
}

TEST(Fluid, IsDisplacedByWhatIsInEachLayer) {
  // half of a cube in water and half in air
  const Displaced half = sea().displacedBy(Solid(BoxShape{{1, 1, 1}}), Quaternion::Identity(), 0);
  EXPECT_NEAR(half.mass, 500.5, 1e-9);
  EXPECT_NEAR(half.first.z(), 500 * -0.25 + 0.5 * 0.25, 1e-9);
  // three layers through one cube
  Fluid fluid(1000);
  fluid.addLayer(-0.25, 800);
  fluid.addLayer(0.25, 1);
  const Displaced three = fluid.displacedBy(Solid(BoxShape{{1, 1, 1}}), Quaternion::Identity(), 0);
  EXPECT_NEAR(three.mass, 250 + 400 + 0.25, 1e-9);
  EXPECT_NEAR(three.first.z(), -250 * 0.375 + 0.25 * 0.375, 1e-9);
}

// On its edge, half of a cube is a prism whose centroid lies a third of its height below the surface.
TEST(Fluid, IsDisplacedByATiltedBodyAsItLies) {
  const Quaternion tilt = fromRollPitchYaw(kPi / 4, 0, 0);
  const Displaced half = sea().displacedBy(Solid(BoxShape{{1, 1, 1}}), tilt, 0);
  EXPECT_NEAR(half.mass, 500.5, 1e-9);
  EXPECT_NEAR((half.first - Vector3(0, 0, -(500 - 0.5) * std::sqrt(0.5) / 3)).norm(), 0, 1e-9);
  // 0.1 m higher
  const Displaced less = sea().displacedBy(Solid(BoxShape{{1, 1, 1}}), tilt, 0.1);
  const double depth = std::sqrt(0.5) - 0.1;
  EXPECT_NEAR(less.mass, 1 + 999 * depth * depth, 1e-9);
}

}  // namespace
}  // namespace pongsim::fluid_test
