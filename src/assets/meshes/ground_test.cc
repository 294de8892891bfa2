#include "assets/meshes/ground.hh"

#include <gtest/gtest.h>

#include "support/png_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

TEST(Ground, HasAPointAPixelTheImagesTopTowardsY) {
  const test::TempFolder folder;
  const auto found = readGround(folder.write("g.png", test::grayPng(2, {0, 50, 100, 0})), {4, 6, 3}, {10, 20, 30});
  const auto* ground = std::get_if<description::TriangleMesh>(&found);
  ASSERT_NE(ground, nullptr) << std::get<Problem>(found).text;
  ASSERT_EQ(ground->vertices.size(), 4U);
  EXPECT_TRUE(ground->vertices[0].isApprox(Vector3(9, 21.5, 30)));
  // the brightest pixel has the height of the size
  EXPECT_TRUE(ground->vertices[1].isApprox(Vector3(11, 21.5, 31.5)));
  EXPECT_TRUE(ground->vertices[2].isApprox(Vector3(9, 18.5, 33)));
  ASSERT_EQ(ground->triangles.size(), 2U);
  for (const auto& [a, b, c] : ground->triangles) {
    const Vector3 normal = (ground->vertices[b] - ground->vertices[a]).cross(ground->vertices[c] - ground->vertices[a]);
    EXPECT_GT(normal.z(), 0);
  }
}

TEST(Ground, SaysWhyAnImageIsNotRead) {
  const test::TempFolder folder;
  const auto found = readGround(folder.write("g.png", "no image"), {1, 1, 1}, Vector3::Zero());
  const auto* problem = std::get_if<Problem>(&found);
  ASSERT_NE(problem, nullptr);
  EXPECT_TRUE(problem->text.starts_with("can't be read as a PNG image: "));
}

}  // namespace
}  // namespace pongsim::assets
