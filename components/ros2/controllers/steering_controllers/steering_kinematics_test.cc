#include "ros2/controllers/steering_controllers/steering_kinematics.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::ros2 {
namespace {

constexpr double kV = 1.2, kTurn = 0.3;

SteeringKinematics car() { return {.wheelRadius = 0.3, .wheelbase = 1.7, .tractionTrack = 1.1, .steeringTrack = 1.0}; }

// all wheels roll about one point on the traction axle's line, v / w to the left
TEST(SteeringKinematics, LetsAllWheelsRollAboutOnePoint) {
  const SteeringKinematics kinematics = car();
  const double radius = kV / kTurn;
  const auto wheels = kinematics.commands(kV, kTurn, kinematics.steeringAngle(kV, kTurn));
  EXPECT_NEAR(wheels.speeds[0], kTurn * (radius + 0.55) / 0.3, 1e-12);
  EXPECT_NEAR(wheels.speeds[1], kTurn * (radius - 0.55) / 0.3, 1e-12);
  EXPECT_NEAR(wheels.angles[0], std::atan(1.7 / (radius + 0.5)), 1e-12);
  EXPECT_NEAR(wheels.angles[1], std::atan(1.7 / (radius - 0.5)), 1e-12);
}

TEST(SteeringKinematics, ComputesVelocitiesFromWheels) {
  const SteeringKinematics kinematics = car();
  for (const double sign : {1.0, -1.0}) {
    const double angle = kinematics.steeringAngle(kV, sign * kTurn);
    const auto wheels = kinematics.commands(kV, sign * kTurn, angle);
    const double measured = kinematics.steeringAngle(wheels.angles);
    EXPECT_NEAR(measured, angle, 1e-12);
    const double linear = kinematics.linearVelocity(wheels.speeds, measured);
    EXPECT_NEAR(linear, kV, 1e-12);
    EXPECT_NEAR(kinematics.angularVelocity(linear, measured), sign * kTurn, 1e-12);
  }
}

TEST(SteeringKinematics, GoesStraightAndStands) {
  const SteeringKinematics kinematics = car();
  const auto wheels = kinematics.commands(kV, 0, 0);
  EXPECT_EQ(wheels.speeds, (std::vector<double>{kV / 0.3, kV / 0.3}));
  EXPECT_EQ(wheels.angles, (std::vector<double>{0, 0}));
  EXPECT_EQ(kinematics.steeringAngle(0, 0), 0);
  EXPECT_NEAR(kinematics.linearVelocity({4, 4}, 0), 1.2, 1e-12);
}

TEST(SteeringKinematics, HasOneWheelOnAnAxle) {
  SteeringKinematics kinematics = car();
  kinematics.tractionWheels = kinematics.steeredWheels = 1;
  const auto wheels = kinematics.commands(kV, kTurn, 0.2);
  EXPECT_EQ(wheels.speeds, std::vector<double>{kV / 0.3});
  ASSERT_EQ(wheels.angles.size(), 1u);
  EXPECT_NEAR(std::tan(wheels.angles[0]), kTurn * 1.7 / kV, 1e-12);
}

}  // namespace
}  // namespace pongsim::ros2
