#include "physics/hulls/hull.hh"

#include <gtest/gtest.h>

#include "support/solids.hh"

namespace pongsim::physics {
namespace {

TEST(ConvexHull, KnowsItsSize) {
  std::vector<Vector3> points = test::boxBetween({1, 1, 1}, {2, 3, 4}).vertices;
  points.emplace_back(1.5, 2, 2);
  const ConvexHull hull = convexHull(points);
  EXPECT_NEAR(hull.volume, 6, 1e-9);
  EXPECT_NEAR(hull.area, 22, 1e-9);
  EXPECT_EQ(hull.corners.size(), 8U);
}

TEST(ConvexHull, IsOfNoVolumeWhereThereIsNone) {
  EXPECT_EQ(convexHull({}).volume, 0);
  const std::vector<Vector3> one{{1, 2, 3}};
  EXPECT_EQ(convexHull(one).volume, 0);
  const std::vector<Vector3> flat{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  EXPECT_NEAR(convexHull(flat).volume, 0, 1e-12);
}

TEST(Hull, DrawsBackByTheMarginThatBulletAdds) {
  const Hull hull = makeHull(test::boxBetween({-1, -1, -1}, {1, 1, 1}).vertices);
  EXPECT_GT(hull.margin, 0);
  EXPECT_EQ(hull.corners.size(), 8U);
  for (const Vector3& corner : hull.corners) {
    EXPECT_NEAR(corner.cwiseAbs().maxCoeff(), 1 - hull.margin, 1e-3);
  }
  EXPECT_NEAR(makeShape(hull)->localGetSupportingVertex({1, 0, 0}).x(), 1, 1e-3);
}

TEST(Hull, OfASheetStandsOutByTheMargin) {
  const Hull hull = makeSheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0.001);
  EXPECT_NEAR(makeShape(hull)->localGetSupportingVertex({0, 0, 1}).z(), 0.001, 1e-6);
  EXPECT_NEAR(makeShape(hull)->localGetSupportingVertex({0, 0, -1}).z(), -0.001, 1e-6);
}

TEST(Outermost, KeepsTheCornersOfABox) {
  std::vector<Vector3> points = test::boxBetween({-1, -1, -1}, {1, 1, 1}).vertices;
  points.emplace_back(0, 0, 0);
  EXPECT_EQ(outermost(points, 100).size(), 8U);
}

}  // namespace
}  // namespace pongsim::physics
