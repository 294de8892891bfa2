#include "physics/gyroscope.hh"

#include <gtest/gtest.h>

#include <LinearMath/btQuaternion.h>

namespace pongsim::physics {
namespace {

TEST(Gyroscope, AsksForNothingWhereABodyTurnsAboutAPrincipalAxisOrIsRound) {
  const btMatrix3x3 upright = btMatrix3x3::getIdentity();
  EXPECT_LT(gyroscopicTorque(upright, {0, 7, 0}, {1, 2, 3}, 0.001).length(), 1e-9);
  EXPECT_LT(gyroscopicTorque(upright, {3, 7, 1}, {2, 2, 2}, 0.001).length(), 1e-9);
  EXPECT_EQ(gyroscopicTorque(upright, {0, 0, 0}, {1, 2, 3}, 0.001), btVector3(0, 0, 0));
}

TEST(Gyroscope, TendsToEulersEquation) {
  // -w x (I w), in the body's frame
  const btVector3 w(1, 2, 3);
  const btVector3 moments(1, 2, 4);
  const btVector3 expected = -w.cross(moments * w);
  const btMatrix3x3 turn(btQuaternion(btVector3(1, 2, -1).normalized(), 0.7));
  const btVector3 found = gyroscopicTorque(turn, turn * w, moments, 1e-5);
  EXPECT_LT((found - turn * expected).length(), 1e-3 * expected.length());
}

}  // namespace
}  // namespace pongsim::physics
