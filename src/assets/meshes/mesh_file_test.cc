#include "assets/meshes/mesh_file.hh"

#include <gtest/gtest.h>

#include <random>

#include "support/assets/mesh_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class MeshFileTest : public ::testing::Test {
 protected:
  std::vector<MeshPart> read(const std::string& name, std::string_view content) {
    auto found = readMeshFile(folder_.write(name, content));
    if (const auto* problem = std::get_if<Problem>(&found)) {
      ADD_FAILURE() << name << " " << problem->text << " " << problem->hint;
      return {};
    }
    return std::get<0>(found);
  }
  std::string problemOf(const std::filesystem::path& file) {
    const auto found = readMeshFile(file);
    const auto* problem = std::get_if<Problem>(&found);
    return problem != nullptr ? problem->text : "(none)";
  }
  test::TempFolder folder_;
};

Eigen::AlignedBox3d boxOf(const description::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

TEST_F(MeshFileTest, ReadsStl) {
  const auto parts = read("a.STL", test::kStl);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].mesh.triangles.size(), 4U);
  // shared vertices are merged
  EXPECT_EQ(parts[0].mesh.vertices.size(), 4U);
  EXPECT_EQ(boxOf(parts[0].mesh).max(), Vector3(1, 1, 1));
}

TEST_F(MeshFileTest, ReadsTheObjectsOfAnObj) {
  const auto parts = read("a.obj", test::kObj);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].nodeName, "square");
  EXPECT_EQ(parts[0].mesh.triangles.size(), 2U);
  EXPECT_EQ(parts[1].nodeName, "triangle");
  EXPECT_EQ(boxOf(parts[1].mesh).max(), Vector3(5, 2, 2));
}

TEST_F(MeshFileTest, ReadsColladaInMetresAndLeavesItsAxesAlone) {
  const auto parts = read("a.dae", test::kCollada);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].nodeName, "left");
  EXPECT_EQ(parts[1].nodeName, "right");
  EXPECT_TRUE(boxOf(parts[1].mesh).min().isApprox(Vector3(1, 0, 0), 1e-6));
  EXPECT_TRUE(boxOf(parts[1].mesh).max().isApprox(Vector3(2, 0, 2), 1e-6));
}

TEST_F(MeshFileTest, ReadsGlb) {
  const auto parts = read("a.glb", test::glb());
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].nodeName, "n");
  EXPECT_EQ(boxOf(parts[0].mesh).max(), Vector3(1, 2, 3));
}

TEST_F(MeshFileTest, SaysWhyAFileIsNotRead) {
  EXPECT_EQ(problemOf("no such.stl"), "no such file");
  EXPECT_EQ(problemOf(folder_.write("huge.glb", std::string("glTF\2\0\0\0\xff\xff\xff\xff\xf0\xff\xff\xffJSON{}", 22))),
            "can't be read as a mesh");
  EXPECT_EQ(problemOf(folder_.write("a.blend", "x")), "is not in a supported format");
  EXPECT_EQ(problemOf(folder_.write("a.dae", "<COLLADA")), "can't be read as a mesh");
  EXPECT_EQ(problemOf(folder_.write("a.stl", "")), "can't be read as a mesh");
  EXPECT_NE(problemOf(folder_.write("b.obj", "v 0 0 0\n")), "(none)");
  EXPECT_NE(problemOf(folder_.write("c.obj", "v 0 0 0\nv 1e999 0 0\nv 0 nan 0\nf 1 2 3\n")), "(none)");
}

TEST_F(MeshFileTest, BearsBrokenFiles) {
  std::mt19937 random(1);
  const std::pair<const char*, std::string> files[] = {{"m.stl", std::string(test::kStl)},
                                                       {"m.obj", std::string(test::kObj)},
                                                       {"m.dae", std::string(test::kCollada)},
                                                       {"m.glb", test::glb()}};
  for (const auto& [name, content] : files) {
    for (int i = 0; i < 100; ++i) {
      std::string broken = content;
      for (int k = 0; k < 3; ++k) broken[random() % broken.size()] = static_cast<char>(random() & 0x7FU);
      if (i % 4 == 0) broken.resize(random() % broken.size());
      const auto found = readMeshFile(folder_.write(name, broken));
      const auto* parts = std::get_if<0>(&found);
      if (parts == nullptr) continue;
      for (const MeshPart& part : *parts) {
        EXPECT_TRUE(!boxOf(part.mesh).isEmpty());
        for (const auto& triangle : part.mesh.triangles) {
          for (const std::uint32_t index : triangle) EXPECT_LT(index, part.mesh.vertices.size());
        }
      }
    }
  }
}

}  // namespace
}  // namespace pongsim::assets
