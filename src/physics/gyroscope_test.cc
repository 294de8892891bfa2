#include "physics/gyroscope.hh"

#include <gtest/gtest.h>

#include <LinearMath/btQuaternion.h>

namespace pongsim::physics {
namespace {

TEST(Gyroscope, AsksForNothingWhereABodyTurnsAboutAPrincipalAxisOrIsRound) {
  const btMatrix3x3 upright = btMatrix3x3::getIdentity();
  EXPECT_LT(gyration(upright, {0, 7, 0}, {1, 2, 3}, 0.001, false)->torque.length(), 1e-9);
  EXPECT_FALSE(gyration(upright, {3, 7, 1}, {2, 2, 2}, 0.001, false));
  EXPECT_FALSE(gyration(upright, {0, 0, 0}, {1, 2, 3}, 0.001, false));
}

TEST(Gyroscope, TendsToEulersEquation) {
  // -w x (I w), in the body's frame
  const btVector3 w(1, 2, 3);
  const btVector3 moments(1, 2, 4);
  const btVector3 expected = -w.cross(moments * w);
  const btMatrix3x3 turn(btQuaternion(btVector3(1, 2, -1).normalized(), 0.7));
  const btVector3 found = gyration(turn, turn * w, moments, 1e-5, false)->torque;
  EXPECT_LT((found - turn * expected).length(), 1e-3 * expected.length());
}

TEST(Gyroscope, KeepsTheMomentumOfWhatIsHeldToo) {
  const btMatrix3x3 turn(btQuaternion(btVector3(1, 2, -1).normalized(), 0.7));
  const btVector3 w(1, 2, 3), moments(1, 2, 4);
  const btVector3 free = gyration(turn, turn * w, moments, 1e-5, false)->torque;
  EXPECT_LT((gyration(turn, turn * w, moments, 1e-5, true)->torque - free).length(), 1e-3 * free.length());
}

TEST(Gyroscope, LooksHalfAStepAhead) {
  const btMatrix3x3 turn(btQuaternion(btVector3(1, 2, -1).normalized(), 0.7));
  // about a principal axis, so that the velocity stays
  const btMatrix3x3 ahead = gyration(turn, turn * btVector3(0, 0, 650), {1e-6, 4e-5, 4e-5}, 0.001, false)->R_WorldAhead;
  const btMatrix3x3 expected = turn * btMatrix3x3(btQuaternion(btVector3(0, 0, 1), 0.325));
  for (int i = 0; i < 3; ++i) EXPECT_LT((ahead[i] - expected[i]).length(), 1e-12);
}

}  // namespace
}  // namespace pongsim::physics
