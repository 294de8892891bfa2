#include "geometry.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::geometry_test {
namespace {

constexpr AckermannGeometry kCar{
    .wheelSeparation = 1, .kingpinWidth = 0.8, .wheelBase = 2, .wheelRadius = 0.5, .steeringLimit = 0.5};

TEST(AckermannCommand, DrivesStraight) {
  const AckermannCommand command = ackermannCommand(kCar, 3, 0);
  EXPECT_NEAR(command.leftAngle, 0, 1e-8);
  EXPECT_NEAR(command.rightAngle, 0, 1e-8);
  EXPECT_NEAR(command.leftSpeed, 6, 1e-8);
  EXPECT_NEAR(command.rightSpeed, 6, 1e-8);
}

TEST(AckermannCommand, PointsAllWheelsAtOneCentre) {
  const AckermannCommand command = ackermannCommand(kCar, 3, 0.3);
  // a circle of 10 m
  EXPECT_NEAR(command.leftAngle, std::atan(2 / 9.6), 1e-12);
  EXPECT_NEAR(command.rightAngle, std::atan(2 / 10.4), 1e-12);
  EXPECT_NEAR(command.leftSpeed, 6 * 0.95, 1e-12);
  EXPECT_NEAR(command.rightSpeed, 6 * 1.05, 1e-12);
}

TEST(AckermannCommand, TurnsNoNarrowerThanItCan) {
  const double narrowest = 2 / std::sin(0.5);
  EXPECT_NEAR(ackermannCommand(kCar, 1, 9).leftAngle, std::atan(2 / (narrowest - 0.4)), 1e-12);
  EXPECT_NEAR(ackermannCommand(kCar, -1, 9).leftAngle, std::atan(2 / (-narrowest - 0.4)), 1e-12);
  EXPECT_NEAR(ackermannCommand(kCar, 0, -1).leftAngle, std::atan(2 / (-narrowest - 0.4)), 1e-12);
  EXPECT_EQ(ackermannCommand(kCar, 0, -1).leftSpeed, 0);
}

// the wheels of an axle point at the centre on the rear axle's line: R = base / tan(angle) from the middle
TEST(AckermannAngles, PointTheWheelsAtOneCentre) {
  const double radius = 2 / std::tan(0.3);
  EXPECT_NEAR(ackermannAngles(kCar, 0.3).leftAngle, std::atan(2 / (radius - 0.5)), 1e-12);
  EXPECT_NEAR(ackermannAngles(kCar, 0.3).rightAngle, std::atan(2 / (radius + 0.5)), 1e-12);
  EXPECT_EQ(ackermannAngles(kCar, 0.3).leftSpeed, 0);
  EXPECT_EQ(ackermannAngles(kCar, -7).leftAngle, ackermannAngles(kCar, -0.5).leftAngle);
}

TEST(AckermannOdometry, FollowsACircle) {
  AckermannOdometry odometry;
  const double steering = std::atan(2.0 / 10);
  // a quarter of a circle of 10 m in small steps
  constexpr int kSteps = 1000;
  const double way = 10 * std::acos(-1.0) / 2;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = way / 0.5 * i / kSteps;
    odometry.update(kCar, angle, angle, steering, 0.01);
  }
  EXPECT_NEAR(odometry.value().x, 10, 0.02);
  EXPECT_NEAR(odometry.value().y, 10, 0.02);
  EXPECT_NEAR(odometry.value().heading, std::acos(-1.0) / 2, 1e-9);
  EXPECT_NEAR(odometry.value().linearVelocity, way / kSteps / 0.01, 1e-9);
}

TEST(AckermannOdometry, StartsAtTheOriginWhateverTheWheelsSay) {
  AckermannOdometry odometry;
  odometry.update(kCar, 7, 8, 0, 0.1);
  EXPECT_EQ(odometry.value().x, 0);
}

}  // namespace
}  // namespace pongsim::geometry_test
