#include "lee_velocity_controller.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pongsim::lee_velocity_controller_test {
namespace {

constexpr double kMass = 1.5;
const Vector3 kGravity(0, 0, -9.8);
const Matrix3 kInertia = Vector3(0.03, 0.07, 0.1).asDiagonal();

Allocation square() {
  return allocationOf({{0.2, -0.2, 1e-5, 0.02, 1},
                       {-0.2, 0.2, 1e-5, 0.02, 1},
                       {0.2, 0.2, 1e-5, 0.02, -1},
                       {-0.2, -0.2, 1e-5, 0.02, -1}});
}

LeeVelocityController controller(double most = std::numeric_limits<double>::infinity()) {
  return {{{3, 3, 3}, {2, 3, 0.2}, {0.4, 0.5, 0.2}, Vector3::Constant(most)}, {kMass, kInertia}, square()};
}

/// @return Torques and thrust that the speeds make.
Eigen::Vector4d effect(const LeeVelocityController& lee, const BodyMotion& motion, const VelocityCommand& command,
                       const Vector3& gravity = kGravity) {
  std::vector<double> speeds;
  lee.compute(motion, command, gravity, speeds);
  Eigen::Vector4d squares;
  for (std::size_t i = 0; i < 4; ++i) squares[static_cast<Eigen::Index>(i)] = speeds[i] * speeds[i];
  return square() * squares;
}

TEST(LeeVelocityController, CarriesTheWeightAtRest) {
  const Eigen::Vector4d found = effect(controller(), {}, {});
  EXPECT_NEAR(found.head<3>().norm(), 0, 1e-12);
  EXPECT_NEAR(found[3], kMass * 9.8, 1e-9);
}

TEST(LeeVelocityController, ClimbsByItsGain) {
  EXPECT_NEAR(effect(controller(), {}, {{0, 0, 0.5}, 0})[3], kMass * 9.8 + 3 * 0.5, 1e-9);
  BodyMotion sinking;
  sinking.velocity.z() = -1;
  EXPECT_NEAR(effect(controller(), sinking, {})[3], kMass * 9.8 + 3, 1e-9);
}

TEST(LeeVelocityController, AsksForNoMoreThanTheLargestAcceleration) {
  EXPECT_NEAR(effect(controller(0.5), {}, {{0, 0, 50}, 0})[3], kMass * (9.8 + 0.5), 1e-9);
  EXPECT_NEAR(effect(controller(0.5), {}, {{0, 0, -50}, 0})[3], kMass * (9.8 - 0.5), 1e-9);
}

TEST(LeeVelocityController, TurnsByItsGains) {
  BodyMotion motion;
  motion.angularVelocity = {0.1, -0.2, 0.3};
  const Eigen::Vector4d found = effect(controller(), motion, {{0, 0, 0}, 0.1});
  EXPECT_NEAR((found.head<3>() - Vector3(-0.4 * 0.1, 0.5 * 0.2, -0.2 * 0.2)).norm(), 0, 1e-9);
}

TEST(LeeVelocityController, StandsUpFromATilt) {
  BodyMotion motion;
  motion.R_WorldBody = fromRollPitchYaw(0.1, 0, 0).toRotationMatrix();
  const Eigen::Vector4d found = effect(controller(), motion, {});
  // the sine of the angle, by the gain of the attitude; the thrust as far as it helps
  EXPECT_NEAR(found[0], -2 * std::sin(0.1), 1e-9);
  EXPECT_NEAR(found[3], kMass * 9.8 * std::cos(0.1), 1e-9);
}

TEST(LeeVelocityController, LeansWhereItIsToGo) {
  const Eigen::Vector4d found = effect(controller(), {}, {{0.5, 0, 0}, 0});
  // the thrust is to point along 3 * 0.5 / m and g
  EXPECT_NEAR(found[1], 3 * std::sin(std::atan(3 * 0.5 / kMass / 9.8)), 1e-9);
  EXPECT_NEAR(found[0], 0, 1e-9);
}

TEST(LeeVelocityController, TakesCommandsInTheAxesOfTheBody) {
  BodyMotion motion;
  motion.R_WorldBody = fromRollPitchYaw(0, 0, 2).toRotationMatrix();
  motion.velocity = motion.R_WorldBody * Vector3(0.5, 0.1, 0);
  EXPECT_NEAR(effect(controller(), motion, {{0.5, 0.1, 0}, 0}).head<3>().norm(), 0, 1e-9);
}

TEST(LeeVelocityController, StaysANumber) {
  for (const Vector3& angles : {Vector3(0, M_PI / 2, 0), Vector3(M_PI / 2, 0, 0), Vector3(M_PI, 0, 0)}) {
    for (const Vector3& gravity : {kGravity, Vector3(0, 0, 0), Vector3(9.8, 0, 0)}) {
      BodyMotion motion;
      motion.R_WorldBody = fromRollPitchYaw(angles.x(), angles.y(), angles.z()).toRotationMatrix();
      EXPECT_TRUE(effect(controller(), motion, {}, gravity).allFinite()) << angles.transpose();
      EXPECT_TRUE(effect(controller(), motion, {{1e6, -1e6, 1e6}, 1e6}, gravity).allFinite()) << angles.transpose();
    }
  }
}

TEST(LeeVelocityController, NeverTurnsARotorBackwards) {
  std::vector<double> speeds;
  controller().compute({}, {{0, 0, -1000}, 0}, kGravity, speeds);
  EXPECT_EQ(speeds, std::vector<double>(4, 0));
}

}  // namespace
}  // namespace pongsim::lee_velocity_controller_test
