#include "pongsim/geometry/rotation_between.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim {
namespace {

TEST(RotationBetween, TurnsOneDirectionIntoTheOther) {
  const Vector3 from(1, -2, 2), to(0.5, 3, 0.1);
  EXPECT_NEAR((rotationBetween(from, to) * from.normalized() - to.normalized()).norm(), 0, 1e-14);
}

TEST(RotationBetween, IsTheSmallestOne) {
  const Quaternion turn = rotationBetween(Vector3::UnitX(), Vector3(1, 1, 0));
  EXPECT_NEAR(turn.angularDistance(Quaternion::Identity()), std::acos(-1) / 4, 1e-14);
  EXPECT_NEAR((turn * Vector3::UnitZ() - Vector3::UnitZ()).norm(), 0, 1e-15);
}

TEST(RotationBetween, IsHalfATurnBetweenOppositeDirections) {
  for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(0, 3, 0), Vector3(1, 2, -2)}) {
    const Quaternion turn = rotationBetween(-axis, axis);
    EXPECT_NEAR(turn.norm(), 1, 1e-15);
    EXPECT_NEAR((turn * axis + axis).norm(), 0, 1e-14 * axis.norm());
  }
}

TEST(RotationBetween, TurnsNearlyOppositeDirectionsIntoEachOther) {
  for (const double off : {0.3, 1e-3, 1e-5, 1e-6, 3e-7, 1e-8, 1e-13, 1e-15}) {
    const Vector3 from(1, 2, -2), to = -from / 3 + off * Vector3(2, -1, 0);
    const Quaternion turn = rotationBetween(from, to);
    EXPECT_NEAR(turn.norm(), 1, 1e-14) << off;
    EXPECT_NEAR((turn * from.normalized() - to.normalized()).norm(), 0, 1e-14) << off;
  }
}

TEST(RotationBetween, OfADirectionAndItselfIsNone) {
  EXPECT_NEAR(rotationBetween(Vector3(1, 2, 3), Vector3(2, 4, 6)).angularDistance(Quaternion::Identity()), 0, 1e-7);
}

}  // namespace
}  // namespace pongsim
