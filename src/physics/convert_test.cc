#include "physics/convert.hh"

#include <gtest/gtest.h>

namespace pongsim::physics {
namespace {

TEST(Convert, TakesVectorsAndTurnsThereAndBack) {
  const Vector3 position(1, -2, 3.5);
  EXPECT_EQ(fromBullet(toBullet(position)), position);
  // all four numbers differ: none may change places
  const Quaternion rotation(0.1, 0.7, -0.5, 0.5);
  const btQuaternion there = toBullet(rotation);
  EXPECT_EQ(there.w(), 0.1);
  EXPECT_EQ(there.x(), 0.7);
  EXPECT_EQ(there.y(), -0.5);
  EXPECT_EQ(there.z(), 0.5);
  EXPECT_EQ(fromBullet(there).coeffs(), rotation.coeffs());
}

TEST(Convert, MovesAPointAsThePoseDoes) {
  const Pose X{Vector3(1, 2, 3), rotationAbout(Vector3(1, 2, 2) / 3, 0.8)};
  const Vector3 point(0.3, -0.4, 0.5);
  const Vector3 moved = X.position + X.rotation * point;
  EXPECT_LT((fromBullet(toBullet(X) * toBullet(point)) - moved).norm(), 1e-15);
  const Pose back = fromBullet(toBullet(X));
  EXPECT_EQ(back.position, X.position);
  EXPECT_LT((back.rotation * point - X.rotation * point).norm(), 1e-15);
}

}  // namespace
}  // namespace pongsim::physics
