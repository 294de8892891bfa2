#include "description/added_mass.hh"

#include <gtest/gtest.h>

namespace pongsim::description {
namespace {

const Matrix3 kMoments = Vector3(0.1, 0.2, 0.3).asDiagonal();

AddedMass with(int row, int column, double value) {
  AddedMass added = AddedMass::Zero();
  added(row, column) = added(column, row) = value;
  return added;
}

TEST(AddedMass, IsPossibleWhereItsSumWithTheBodyIsPositiveDefinite) {
  EXPECT_TRUE(isPossible(AddedMass::Zero(), 2, Pose(), kMoments));
  // the mass is 2: one on the diagonal may be above -2, one beside it must be below 2
  EXPECT_TRUE(isPossible(with(0, 0, -1.9), 2, Pose(), kMoments));
  EXPECT_FALSE(isPossible(with(0, 0, -2), 2, Pose(), kMoments));
  EXPECT_TRUE(isPossible(with(0, 1, 1.9), 2, Pose(), kMoments));
  EXPECT_FALSE(isPossible(with(0, 1, 2), 2, Pose(), kMoments));
  // of x and p: the square must be below 2 * 0.1
  EXPECT_TRUE(isPossible(with(0, 3, 0.44), 2, Pose(), kMoments));
  EXPECT_FALSE(isPossible(with(0, 3, 0.45), 2, Pose(), kMoments));
}

TEST(AddedMass, IsAboutTheLinkFrameNotTheCentreOfMass) {
  // 2 kg at 0.5 m along y, about the origin: x and r are coupled by -1 kg m, and r has 0.3 + 0.5 kg m^2
  const Pose X_LinkCom{{0, 0.5, 0}, Quaternion::Identity()};
  EXPECT_TRUE(isPossible(with(0, 5, 1), 2, X_LinkCom, kMoments));
  EXPECT_FALSE(isPossible(with(0, 5, -0.3), 2, X_LinkCom, kMoments));
  // the frame of the moments is turned: the 0.1 are about y
  const Pose X_Turned{{0, 0, 0}, rotationAbout(Vector3::UnitZ(), 1.5707963267948966)};
  EXPECT_TRUE(isPossible(with(4, 4, -0.09), 2, X_Turned, kMoments));
  EXPECT_FALSE(isPossible(with(4, 4, -0.11), 2, X_Turned, kMoments));
}

TEST(AddedMass, MayBeOfAnySize) {
  EXPECT_TRUE(isPossible(1e20 * AddedMass::Identity(), 1e-20, Pose(), 1e-25 * Matrix3::Identity()));
  EXPECT_FALSE(isPossible(-1e20 * AddedMass::Identity(), 1e-20, Pose(), 1e-25 * Matrix3::Identity()));
}

}  // namespace
}  // namespace pongsim::description
