#include "kinematics.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim::mecanum_kinematics_test {
namespace {

constexpr MecanumGeometry kGeometry{.wheelSeparation = 0.4, .wheelbase = 0.6, .wheelRadius = 0.1};

TEST(MecanumKinematics, TurnsAllWheelsAlikeForwardAndInPairsSideways) {
  const MecanumWheels forward = wheelsFor(kGeometry, {1, 0, 0});
  for (const double speed : {forward.frontLeft, forward.frontRight, forward.backLeft, forward.backRight}) {
    EXPECT_DOUBLE_EQ(speed, 10);
  }
  const MecanumWheels left = wheelsFor(kGeometry, {0, 1, 0});
  EXPECT_DOUBLE_EQ(left.frontLeft, -10);
  EXPECT_DOUBLE_EQ(left.frontRight, 10);
  EXPECT_DOUBLE_EQ(left.backLeft, 10);
  EXPECT_DOUBLE_EQ(left.backRight, -10);
  const MecanumWheels turn = wheelsFor(kGeometry, {0, 0, 1});
  EXPECT_DOUBLE_EQ(turn.frontLeft, -5);
  EXPECT_DOUBLE_EQ(turn.frontRight, 5);
  EXPECT_DOUBLE_EQ(turn.backLeft, -5);
  EXPECT_DOUBLE_EQ(turn.backRight, 5);
}

TEST(MecanumKinematics, FindsTheTwistOfItsWheels) {
  const PlanarTwist twist = twistOf(kGeometry, wheelsFor(kGeometry, {0.3, -0.5, 0.7}));
  EXPECT_NEAR(twist.x, 0.3, 1e-12);
  EXPECT_NEAR(twist.y, -0.5, 1e-12);
  EXPECT_NEAR(twist.yaw, 0.7, 1e-12);
}

MecanumWheels after(const PlanarTwist& twist, double seconds) {
  const MecanumWheels speeds = wheelsFor(kGeometry, twist);
  return {speeds.frontLeft * seconds, speeds.frontRight * seconds, speeds.backLeft * seconds,
          speeds.backRight * seconds};
}

TEST(MecanumOdometry, StartsAtTheOriginWhateverTheWheelsSay) {
  MecanumOdometry odometry;
  odometry.update(kGeometry, {1, 2, 3, 4}, 0.1);
  EXPECT_EQ(odometry.value().x, 0);
  EXPECT_EQ(odometry.value().y, 0);
  EXPECT_EQ(odometry.value().heading, 0);
}

TEST(MecanumOdometry, ClosesACircleThatItGoesRoundSideways) {
  // to the left at 0.5 m/s while it turns at 1 rad/s: about a point half a metre behind
  MecanumOdometry odometry;
  constexpr int kSteps = 360;
  double farthest = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double time = 2 * std::numbers::pi * i / kSteps;
    odometry.update(kGeometry, after({0, 0.5, 1}, time), 2 * std::numbers::pi / kSteps);
    farthest = std::max(farthest, -odometry.value().x);
  }
  EXPECT_NEAR(farthest, 1, 1e-9);
  EXPECT_NEAR(odometry.value().x, 0, 1e-9);
  EXPECT_NEAR(odometry.value().y, 0, 1e-9);
  EXPECT_NEAR(odometry.value().heading, 2 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(odometry.value().lateralVelocity, 0.5, 1e-9);
  EXPECT_NEAR(odometry.value().angularVelocity, 1, 1e-9);
  EXPECT_NEAR(odometry.value().linearVelocity, 0, 1e-9);
}

}  // namespace
}  // namespace pongsim::mecanum_kinematics_test
