#include "ros2/services/convex.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim::ros2::convex_test {
namespace {

const Pose kTurned{{1, 2, 3}, fromRollPitchYaw(0, 0, std::numbers::pi / 4)};

Convex at(const Shape& shape, const Pose& pose) { return convexOf(shape, pose).value(); }
Pose shifted(double x, double y = 0, double z = 0) { return {{x, y, z}, Quaternion::Identity()}; }

void expectBox(const Convex& convex, const Vector3& lower, const Vector3& upper) {
  const Eigen::AlignedBox3d box = boxAround(convex);
  EXPECT_TRUE(box.min().isApprox(lower, 1e-12)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(upper, 1e-12)) << box.max().transpose();
}

TEST(Convex, HasTheBoxOfItsShape) {
  const double h = std::sqrt(2);
  expectBox(at(BoxShape{{2, 2, 4}}, kTurned), {1 - h, 2 - h, 1}, {1 + h, 2 + h, 5});
  expectBox(at(SphereShape{2}, kTurned), {-1, 0, 1}, {3, 4, 5});
  expectBox(at(CylinderShape{1, 4}, kTurned), {0, 1, 1}, {2, 3, 5});
  expectBox(at(CapsuleShape{1, 4}, kTurned), {0, 1, 0}, {2, 3, 6});
  expectBox(at(EllipsoidShape{{1, 2, 3}}, shifted(1)), {0, -2, -3}, {2, 2, 3});
  expectBox(convexHull({{0, 1, 2}, {3, 0, 0}, {1, 5, -1}}), {0, 0, -1}, {3, 5, 2});
}

TEST(Convex, EllipsoidThatIsTurnedHasTheBoxOfItsMatrix) {
  // the half width along a unit vector u is |S R^T u|
  const Quaternion rotation = fromRollPitchYaw(0.3, 0.5, 0.7);
  const Vector3 radii(1, 2, 3);
  const Eigen::AlignedBox3d box = boxAround(at(EllipsoidShape{radii}, {Vector3::Zero(), rotation}));
  for (int axis = 0; axis < 3; ++axis) {
    const double half = radii.cwiseProduct(rotation.conjugate() * Vector3::Unit(axis)).norm();
    EXPECT_NEAR(box.max()[axis], half, 1e-12);
    EXPECT_NEAR(box.min()[axis], -half, 1e-12);
  }
}

TEST(Convex, IsNothingOfWhatIsNotConvexOrHasNoEnd) {
  EXPECT_FALSE(convexOf(NoShape(), Pose()).has_value());
  EXPECT_FALSE(convexOf(PlaneShape(), Pose()).has_value());
  EXPECT_FALSE(convexOf(TriangleShape(), Pose()).has_value());
}

TEST(Convex, OverlapsWhatItReaches) {
  const Convex box = at(BoxShape{{2, 2, 2}}, Pose());
  EXPECT_TRUE(overlap(box, at(SphereShape{0.5}, shifted(1.4))));
  EXPECT_FALSE(overlap(box, at(SphereShape{0.5}, shifted(1.6))));
  // beside the corner, where their boxes overlap
  EXPECT_FALSE(overlap(box, at(SphereShape{0.5}, shifted(1.4, 1.4, 1.4))));
  EXPECT_TRUE(overlap(box, at(SphereShape{0.5}, shifted(1.2, 1.2, 1.2))));
  // one inside the other, in both orders
  EXPECT_TRUE(overlap(box, at(CylinderShape{0.1, 0.1}, shifted(0.5))));
  EXPECT_TRUE(overlap(at(CylinderShape{0.1, 0.1}, shifted(0.5)), box));
  EXPECT_TRUE(overlap(box, box));
  EXPECT_TRUE(overlap(box, convexHull({{0.2, 0.3, 0.4}})));
  EXPECT_FALSE(overlap(box, convexHull({{0.2, 0.3, 1.4}})));
  // a flat hull
  EXPECT_TRUE(overlap(box, convexHull({{-5, -5, 0.5}, {5, -5, 0.5}, {0, 5, 0.5}})));
  EXPECT_FALSE(overlap(box, convexHull({{-5, -5, 1.5}, {5, -5, 1.5}, {0, 5, 1.5}})));
}

TEST(Convex, OverlapsAlikeAtEachDistance) {
  // spheres, whose result is known
  for (int i = 1; i < 200; ++i) {
    const double distance = 0.02 * i + 0.005;
    const Pose there{distance * Vector3(1, 2, -2) / 3, fromRollPitchYaw(0.1 * i, 0.2 * i, 0)};
    EXPECT_EQ(overlap(at(SphereShape{1.5}, Pose()), at(SphereShape{0.5}, there)), distance < 2) << distance;
  }
}

}  // namespace
}  // namespace pongsim::ros2::convex_test
