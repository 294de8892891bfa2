#include "security/new_folder.hh"

#include <gtest/gtest.h>

#include "shared/program/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::security {
namespace {

namespace fs = std::filesystem;

TEST(NewFolder, ComesToItsPlaceWhole) {
  const test::TempFolder folder;
  NewFolder made(folder.path());
  made.write("a/b", "text");
  made.link("c", "a/b");
  EXPECT_FALSE(fs::exists(folder.path() / "place"));
  EXPECT_TRUE(made.put(folder.path() / "deep/place"));
  EXPECT_EQ(fs::file_size(folder.path() / "deep/place/a/b"), 4U);
  EXPECT_EQ(fs::read_symlink(folder.path() / "deep/place/c"), "a/b");
}

TEST(NewFolder, LeavesNothingBehindUnlessItIsPut) {
  const test::TempFolder folder;
  { NewFolder(folder.path()).write("a", "text"); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(NewFolder, TakesThePlaceOfAnEmptyFolderAndOfNothingElse) {
  const test::TempFolder folder;
  fs::create_directory(folder.path() / "empty");
  EXPECT_TRUE(NewFolder(folder.path()).put(folder.path() / "empty"));
  folder.write("full/file", "text");
  EXPECT_FALSE(NewFolder(folder.path()).put(folder.path() / "full"));
  folder.write("file", "text");
  EXPECT_FALSE(NewFolder(folder.path()).put(folder.path() / "file"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 3);
}

TEST(NewFolder, SaysWhereItCanNotBe) {
  const test::TempFolder folder;
  folder.write("file", "text");
  EXPECT_THROW(NewFolder(folder.path() / "file/below"), cli::Failure);
}

}  // namespace
}  // namespace pongsim::security
