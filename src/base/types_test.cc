#include "pongsim/types.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace pongsim {
namespace {

TEST(RollPitchYaw, OfARotationMakeItAgain) {
  for (const Vector3& angles : {Vector3(0, 0, 0), Vector3(0.1, -0.2, 3), Vector3(-3, 1.5, -1), Vector3(2, -1.5, 0)}) {
    const Vector3 found = rollPitchYawOf(fromRollPitchYaw(angles.x(), angles.y(), angles.z()));
    EXPECT_NEAR((found - angles).norm(), 0, 1e-12) << angles.transpose();
  }
}

TEST(RollPitchYaw, StayFiniteWherePitchIsAQuarterTurn) {
  const Quaternion up = fromRollPitchYaw(0.3, std::numbers::pi / 2, 0.1);
  const Vector3 angles = rollPitchYawOf(up);
  EXPECT_TRUE(angles.allFinite());
  EXPECT_NEAR(angles.y(), std::numbers::pi / 2, 1e-7);
}

}  // namespace
}  // namespace pongsim
