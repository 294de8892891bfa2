#include "assets/meshes/mesh_files.hh"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class MeshFilesTest : public ::testing::Test {
 protected:
  MeshFilesTest() : mesh_(folder_.write("model/meshes/m.obj", "on disk")), files_(mesh_, "given") {}

  /// @return What Assimp reads of a file; nothing if it can't be opened.
  std::optional<std::string> contentOf(const std::filesystem::path& name) {
    aiFileIO* io = files_.io();
    aiFile* file = io->OpenProc(io, name.c_str(), "rb");
    if (file == nullptr) return std::nullopt;
    std::string content(file->FileSizeProc(file), '.');
    EXPECT_EQ(file->ReadProc(file, content.data(), 1, content.size() + 5), content.size());
    io->CloseProc(io, file);
    return content;
  }

  test::TempFolder folder_;
  std::filesystem::path mesh_;
  MeshFiles files_;
};

TEST_F(MeshFilesTest, HasTheMeshAndWhatIsBesideIt) {
  EXPECT_EQ(contentOf(mesh_), "given");
  folder_.write("model/meshes/m.mtl", "materials");
  EXPECT_EQ(contentOf(mesh_.parent_path() / "m.mtl"), "materials");
  folder_.write("model/materials/n.mtl", "more");
  EXPECT_EQ(contentOf(mesh_.parent_path() / "../materials/n.mtl"), "more");
  EXPECT_EQ(contentOf(mesh_.parent_path() / "gone.mtl"), std::nullopt);
}

TEST_F(MeshFilesTest, HasNoFileOfAnotherModel) {
  folder_.write("secret.txt", "secret");
  EXPECT_EQ(contentOf(mesh_.parent_path() / "../../secret.txt"), std::nullopt);
  std::filesystem::create_symlink("../../secret.txt", mesh_.parent_path() / "link.mtl");
  EXPECT_EQ(contentOf(mesh_.parent_path() / "link.mtl"), std::nullopt);
  EXPECT_EQ(contentOf("/etc/passwd"), std::nullopt);
}

TEST_F(MeshFilesTest, WaitsForNoPipe) {
  const std::filesystem::path pipe = mesh_.parent_path() / "pipe.mtl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(contentOf(pipe), std::nullopt);
}

TEST_F(MeshFilesTest, CanBeReadInPartsButNotWritten) {
  aiFileIO* io = files_.io();
  EXPECT_EQ(io->OpenProc(io, mesh_.c_str(), "wb"), nullptr);
  aiFile* file = io->OpenProc(io, mesh_.c_str(), "rb");
  ASSERT_NE(file, nullptr);
  std::string bytes(2, '.');
  EXPECT_EQ(file->SeekProc(file, 2, aiOrigin_SET), aiReturn_SUCCESS);
  EXPECT_EQ(file->ReadProc(file, bytes.data(), 2, 1), 1U);
  EXPECT_EQ(bytes, "ve");
  EXPECT_EQ(file->TellProc(file), 4U);
  // whole elements only
  EXPECT_EQ(file->ReadProc(file, bytes.data(), 2, 1), 0U);
  EXPECT_EQ(file->SeekProc(file, 6, aiOrigin_SET), aiReturn_FAILURE);
  EXPECT_EQ(file->SeekProc(file, 5, aiOrigin_END), aiReturn_SUCCESS);
  EXPECT_EQ(file->ReadProc(file, bytes.data(), 1, 2), 2U);
  EXPECT_EQ(bytes, "gi");
  io->CloseProc(io, file);
}

}  // namespace
}  // namespace pongsim::assets
