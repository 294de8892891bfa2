#include "hull.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::hull_test {
namespace {

constexpr HullSettings kHull{.density = 1.2,
                             .inviscidForce = 0.8,
                             .viscousForce = 3,
                             .inviscidMoment = 2.5,
                             .viscousMoment = 7,
                             .separation = 4,
                             .axialDrag = 1.5};

// q = 60 Pa at 10 m/s
TEST(Hull, IsOnlyBrakedInAFlowFromAhead) {
  const Wrench wrench = hullWrench(kHull, {10, 0, 0}, {0, 0, 0});
  EXPECT_NEAR((wrench.force - Vector3(-60 * 1.5, 0, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(wrench.torque.norm(), 0);
}

TEST(Hull, IsPushedBackAndTurnedByAFlowFromTheSide) {
  const double angle = 0.3, sine = std::sin(angle);
  const double force = 60 * (3 * sine * sine - 0.8 * std::sin(2 * angle));
  const double moment = 60 * (7 * sine * sine - 2.5 * std::sin(2 * angle));
  const Wrench side = hullWrench(kHull, {10 * std::cos(angle), 10 * sine, 0}, {0, 0, 0});
  EXPECT_NEAR(side.force.y(), -force, 1e-9);
  EXPECT_NEAR(side.torque.z(), -moment, 1e-9);
  EXPECT_NEAR(side.force.x(), -60 * 1.5, 1e-9);
  const Wrench below = hullWrench(kHull, {10 * std::cos(angle), 0, 10 * sine}, {0, 0, 0});
  EXPECT_NEAR(below.force.z(), -force, 1e-9);
  EXPECT_NEAR(below.torque.y(), moment, 1e-9);
  // the axial drag goes with the square of the cosine of the angle of attack
  EXPECT_NEAR(below.force.x(), -60 * 1.5 * std::cos(angle) * std::cos(angle), 1e-9);
}

// a hull that yaws moves sideways at its tail
TEST(Hull, FeelsItsRatesWhereTheFlowSeparates) {
  const Wrench turning = hullWrench(kHull, {10, 0, 0}, {0, 0, 0.5});
  const Wrench drifting = hullWrench(kHull, {10, -2, 0}, {0, 0, 0});
  EXPECT_NEAR(turning.force.y(), drifting.force.y(), 1e-9);
  EXPECT_NEAR(turning.torque.z(), drifting.torque.z(), 1e-9);
}

TEST(Hull, IsAtRestWithoutForce) {
  EXPECT_EQ(hullWrench(kHull, {0, 0, 0}, {0, 0, 0}).force.norm(), 0);
  EXPECT_EQ(hullWrench(kHull, {0, 0, 0}, {1, 0, 0}).torque.norm(), 0);
}

}  // namespace
}  // namespace pongsim::hull_test
