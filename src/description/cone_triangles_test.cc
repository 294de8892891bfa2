#include "description/cone_triangles.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pongsim/geometry/solid.hh"

namespace pongsim::description {
namespace {

TEST(ConeTriangles, HaveTheVolumeOfTheCone) {
  const TriangleMesh mesh = coneTriangles({0.5, 2});
  const Solid solid(TriangleShape{mesh.vertices, mesh.triangles});
  EXPECT_TRUE(solid.isClosed());
  EXPECT_NEAR(solid.volume().size, std::numbers::pi * 0.25 * 2 / 3, 1e-12);
  EXPECT_LT((solid.volume().center - Vector3(0, 0, -0.5)).norm(), 1e-12);
  for (const Vector3& vertex : mesh.vertices) EXPECT_LE(std::hypot(vertex.x(), vertex.y()), 0.5 * 1.0015);
}

}  // namespace
}  // namespace pongsim::description
