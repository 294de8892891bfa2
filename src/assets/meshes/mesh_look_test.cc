#include "assets/meshes/mesh_look.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <variant>
#include <vector>

#include "support/assets/mesh_support.hh"
#include "support/png_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

using pongsim::test::TempFolder;

TEST(MeshLook, HasTheMaterialsOfItsParts) {
  const TempFolder folder;
  folder.write("wood.png", pongsim::test::grayPng(1, {9}));
  folder.write("m.mtl",
               "newmtl red\nKd 1 0 0\nnewmtl wooden\nKd 1 1 1\nmap_Kd wood.png\nnewmtl lost\nmap_Kd gone.png\n");
  const auto file = folder.write("m.obj",
                                 "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0.25 0.75\n"
                                 "o a\nusemtl red\nf 1/1 2/1 3/1\no b\nusemtl wooden\nf 1/1 2/1 3/1\n"
                                 "o c\nusemtl lost\nf 1/1 2/1 3/1\n");
  const auto read = readMeshLook(file, "", false);
  const auto* looks = std::get_if<std::vector<MeshLook>>(&read);
  ASSERT_NE(looks, nullptr);
  ASSERT_EQ(looks->size(), 3U);
  ASSERT_TRUE((*looks)[0].material);
  EXPECT_EQ((*looks)[0].material->diffuse, (description::Color{1, 0, 0, 1}));
  EXPECT_FALSE((*looks)[0].material->metal);
  ASSERT_TRUE((*looks)[1].material && (*looks)[1].material->metal);
  EXPECT_EQ((*looks)[1].material->metal->maps.albedo.file, folder.path() / "wood.png");
  EXPECT_FALSE((*looks)[2].material->metal);
  // computed, because the file has none; texture coordinates count from the top
  EXPECT_TRUE((*looks)[0].corners[0].normal.isApprox(Eigen::Vector3f::UnitZ()));
  EXPECT_TRUE((*looks)[0].corners[0].coordinates.isApprox(Eigen::Vector2f(0.25F, 0.25F)));
}

TEST(MeshLook, HasTheTexturesOfItsModel) {
  const TempFolder folder;
  folder.write("materials/textures/wood.png", pongsim::test::grayPng(1, {9}));
  folder.write("meshes/m.mtl", "newmtl wooden\nmap_Kd wood.png\n");
  const auto file = folder.write("meshes/m.obj",
                                 "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0.25 0.75\n"
                                 "o a\nusemtl wooden\nf 1/1 2/1 3/1\n");
  const auto read = readMeshLook(file, "", false);
  const auto* looks = std::get_if<std::vector<MeshLook>>(&read);
  ASSERT_NE(looks, nullptr);
  ASSERT_TRUE((*looks)[0].material && (*looks)[0].material->metal);
  EXPECT_TRUE(std::filesystem::equivalent((*looks)[0].material->metal->maps.albedo.file,
                                          folder.path() / "materials/textures/wood.png"));
}

TEST(MeshLook, IsOfThePartThatIsAskedFor) {
  const TempFolder folder;
  const auto file = folder.write("m.obj", test::kObj);
  const auto read = readMeshLook(file, "triangle", true);
  const auto* looks = std::get_if<std::vector<MeshLook>>(&read);
  ASSERT_NE(looks, nullptr);
  ASSERT_EQ(looks->size(), 1U);
  EXPECT_FALSE((*looks)[0].material);
  Eigen::AlignedBox3f box;
  for (const MeshLook::Corner& corner : (*looks)[0].corners) box.extend(corner.position);
  EXPECT_TRUE(box.center().isZero(1e-6F));

  const auto missing = readMeshLook(file, "wheel", false);
  ASSERT_TRUE(std::holds_alternative<Problem>(missing));
  EXPECT_EQ(std::get<Problem>(missing).text, "has no submesh 'wheel'");
}

TEST(MeshLook, TellsWhatIsWrongWithAFile) {
  const TempFolder folder;
  for (const char* name : {"m.obj", "m.stl", "m.xyz"}) {
    EXPECT_TRUE(std::holds_alternative<Problem>(readMeshLook(folder.write(name, "nothing"), "", false))) << name;
  }
}

}  // namespace
}  // namespace pongsim::assets
