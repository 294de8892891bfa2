#include "propeller.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::propeller_test {
namespace {

// T = rho Kt D^4 n^2
TEST(Propeller, TurnsAsFastAsItsThrustTakes) {
  Propeller propeller({.diameter = 0.25, .density = 950, .coefficient = 0.005});
  const double speed = std::sqrt(100 / (950 * 0.005 * std::pow(0.25, 4)));
  EXPECT_DOUBLE_EQ(propeller.turnFor(100), speed);
  EXPECT_DOUBLE_EQ(propeller.turnFor(-100), -speed);
  EXPECT_EQ(propeller.turnFor(0), 0);
  EXPECT_DOUBLE_EQ(950 * 0.005 * std::pow(0.25, 4) * speed * speed, 100);
}

TEST(Propeller, TurnsTheOtherWayWithANegativeCoefficient) {
  const Propeller propeller({.diameter = 0.5, .density = 1000, .coefficient = -0.004});
  EXPECT_DOUBLE_EQ(propeller.speedFor(100), -std::sqrt(100 / (1000 * 0.004 * std::pow(0.5, 4))));
  EXPECT_DOUBLE_EQ(propeller.thrustAt(-20), 1000 * 0.004 * std::pow(0.5, 4) * 400);
  EXPECT_DOUBLE_EQ(propeller.thrustAt(propeller.speedFor(-7)), -7);
}

// Kt = alpha_1 + alpha_2 (1 - w) V / (n D), from the speed of the step before
TEST(Propeller, HasACoefficientThatFollowsFromItsAdvance) {
  Propeller propeller({.diameter = 0.2, .density = 1000, .wakeFraction = 0.25, .alpha1 = 0.9, .alpha2 = -0.3});
  // at first there is nothing to make it from
  EXPECT_DOUBLE_EQ(propeller.turnFor(50), std::sqrt(50 / (1000 * std::pow(0.2, 4))));
  propeller.setCraftSpeed(2);
  const double coefficient = 0.9 - 0.3 * 0.75 * 2 / (propeller.speed() * 0.2);
  EXPECT_DOUBLE_EQ(propeller.turnFor(50), std::sqrt(50 / (1000 * coefficient * std::pow(0.2, 4))));
  propeller.reset();
  EXPECT_EQ(propeller.speed(), 0);
  EXPECT_DOUBLE_EQ(propeller.turnFor(50), std::sqrt(50 / (1000 * std::pow(0.2, 4))));
}

TEST(Propeller, KeepsItsCoefficientWhereTheAdvanceTakesItAway) {
  Propeller propeller({.diameter = 1, .density = 1, .wakeFraction = 0, .alpha1 = 1, .alpha2 = -1});
  propeller.turnFor(4);
  propeller.setCraftSpeed(2);
  EXPECT_DOUBLE_EQ(propeller.turnFor(9), 3);
}

}  // namespace
}  // namespace pongsim::propeller_test
