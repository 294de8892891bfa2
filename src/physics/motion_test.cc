#include "physics/motion.hh"

#include <LinearMath/btTransformUtil.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace pongsim::physics {
namespace {

double difference(const btTransform& a, const btTransform& b) {
  double most = (a.getOrigin() - b.getOrigin()).length();
  for (int row = 0; row < 3; ++row) most = std::max(most, (a.getBasis()[row] - b.getBasis()[row]).length());
  return most;
}

TEST(Motion, IsWhatBulletMakesOfVelocities) {
  const btTransform start(btQuaternion(btVector3(1, 2, -3).normalized(), 0.7), btVector3(4, 5, 6));
  // at rest, slow, at the usual speeds, and faster than is followed
  for (const double speed : {0.0, 1e-9, 5e-4, 0.02, 1.0, 300.0, 5000.0}) {
    const btVector3 linear(0.1 * speed, -speed, 3), angular = btVector3(-0.3, 0.5, 0.8) * speed;
    btTransform expected;
    btTransformUtil::integrateTransform(start, linear, angular, 1e-3, expected);
    EXPECT_LT(difference(moved(start, linear, angular, 1e-3), expected), 1e-14) << speed;
  }
}

TEST(Motion, GoesStraightWhereNothingTurns) {
  const btTransform start(btMatrix3x3::getIdentity(), btVector3(1, 0, 0));
  const btTransform then = moved(start, btVector3(0, 2, 0), btVector3(0, 0, 0), 0.5);
  EXPECT_EQ(difference(then, btTransform(btMatrix3x3::getIdentity(), btVector3(1, 1, 0))), 0);
}

TEST(Motion, TurnsAboutAnAxis) {
  const btVector3 turned = quatRotate(turnAbout(btVector3(0, 0, 1), std::numbers::pi / 2), btVector3(1, 0, 0));
  EXPECT_LT((turned - btVector3(0, 1, 0)).length(), 1e-15);
}

}  // namespace
}  // namespace pongsim::physics
