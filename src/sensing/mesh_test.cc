#include "sensing/mesh.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace pongsim::sensing {
namespace {

/// @return A triangle at x = `distance`, seen from the origin's side.
std::shared_ptr<const description::TriangleMesh> triangleAt(double distance) {
  auto mesh = std::make_shared<description::TriangleMesh>();
  mesh->vertices = {{distance, -1, -1}, {distance, 0, 1}, {distance, 1, -1}};
  mesh->triangles = {{0, 1, 2}};
  return mesh;
}

class MeshTest : public testing::Test {
 protected:
  DevicePointer device_{embree().newDevice("threads=1")};
};

TEST_F(MeshTest, IsSeenFromWhereItsCornersGoRoundCounterClockwise) {
  const Mesh mesh(device_.get(), triangleAt(3));
  const Line ahead{{0, 0, 0}, {1, 0, 0}}, back{{5, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(mesh.firstHit(ahead, 0, 10, false), 3);
  EXPECT_EQ(mesh.firstHit(back, 0, 10, false), kNowhere);
  EXPECT_EQ(mesh.firstHit(back, 0, 10, true), 2);
}

TEST_F(MeshTest, IsSeenBetweenTheTwoLimitsOnly) {
  const Mesh mesh(device_.get(), triangleAt(3));
  const Line line{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(mesh.firstHit(line, 0, 2.9, false), kNowhere);
  EXPECT_EQ(mesh.firstHit(line, 3.1, 10, false), kNowhere);
  EXPECT_EQ(mesh.firstHit({{0, 0, 0}, {2, 0, 0}}, 0, 10, false), 1.5);
  EXPECT_EQ(mesh.firstHit({{0, 1.1, 0}, {1, 0, 0}}, 0, 10, false), kNowhere);
}

TEST_F(MeshTest, IsMetInDoublePrecisionHoweverFarItIs) {
  const double far = 12'345.678'901'234;
  const Mesh mesh(device_.get(), triangleAt(far));
  EXPECT_NEAR(mesh.firstHit({{0, 0, 0}, {1, 0, 0}}, 0, kNowhere, false), far, 1e-9);
  const Vector3 direction = Vector3(1, 2e-5, -3e-5).normalized();
  EXPECT_NEAR(mesh.firstHit({{0, 0, 0}, direction}, 0, kNowhere, false), far / direction.x(), 1e-8);
}

TEST_F(MeshTest, HasNoHolesBetweenItsTriangles) {
  // a sheet of 20 by 20 squares, each of two triangles
  constexpr int kSide = 20;
  auto sheet = std::make_shared<description::TriangleMesh>();
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) sheet->vertices.emplace_back(i * 0.1, j * 0.1, 7);
  }
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      const std::uint32_t a = i * (kSide + 1) + j, b = a + kSide + 1;
      sheet->triangles.push_back({a, b, b + 1});
      sheet->triangles.push_back({a, b + 1, a + 1});
    }
  }
  const Mesh mesh(device_.get(), sheet);
  // beams along all the edges
  for (int i = 1; i < kSide; ++i) {
    for (int k = 1; k < 200; ++k) {
      EXPECT_EQ(mesh.firstHit({{i * 0.1, k * 0.01, 9}, {0, 0, -1}}, 0, 10, false), 2) << i << ' ' << k;
      EXPECT_EQ(mesh.firstHit({{k * 0.01, i * 0.1, 9}, {0, 0, -1}}, 0, 10, false), 2) << i << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace pongsim::sensing
