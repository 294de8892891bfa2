#include "assets/meshes/mesh_store.hh"

#include <gtest/gtest.h>

#include "support/assets/mesh_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class MeshStoreTest : public ::testing::Test {
 protected:
  const test::TempFolder folder_;
  const std::filesystem::path file_ = folder_.write("a.obj", test::kObj);
  MeshStore store_;
};

TEST_F(MeshStoreTest, MakesOneMeshOfAllParts) {
  const auto found = store_.find(file_, "", true);
  const auto& mesh = *std::get<0>(found);
  EXPECT_EQ(mesh.vertices.size(), 7U);
  ASSERT_EQ(mesh.triangles.size(), 3U);
  for (const std::uint32_t index : mesh.triangles[2]) EXPECT_EQ(mesh.vertices[index].x(), 5);
}

TEST_F(MeshStoreTest, FindsAPartByItsName) {
  const auto& mesh = *std::get<0>(store_.find(file_, "triangle", false));
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0].x(), 5);
}

TEST_F(MeshStoreTest, CentersAPart) {
  const auto& mesh = *std::get<0>(store_.find(file_, "triangle", true));
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  EXPECT_EQ(box.min(), Vector3(0, -1, -1));
  EXPECT_EQ(box.max(), Vector3(0, 1, 1));
}

TEST_F(MeshStoreTest, SharesAndReadsOnce) {
  const auto first = store_.find(file_, "", false);
  std::filesystem::remove(file_);
  EXPECT_EQ(std::get<0>(store_.find(file_, "", false)), std::get<0>(first));
  EXPECT_EQ(std::get<0>(store_.find(file_, "square", false))->triangles.size(), 2U);
}

TEST_F(MeshStoreTest, NamesAPartThatIsNotThere) {
  const auto found = store_.find(file_, "triangel", false);
  EXPECT_EQ(std::get<Problem>(found).text, "has no submesh 'triangel'");
  EXPECT_EQ(std::get<Problem>(found).hint, "did you mean 'triangle'?");
}

}  // namespace
}  // namespace pongsim::assets
