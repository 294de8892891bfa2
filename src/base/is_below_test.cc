#include "base/is_below.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::base {
namespace {

namespace fs = std::filesystem;

TEST(IsBelow, KnowsWhatLiesInAFolder) {
  const test::TempFolder folder;
  const fs::path file = folder.write("a/b.sdf", "");
  EXPECT_TRUE(isBelow(file, folder.path()));
  EXPECT_TRUE(isBelow(file, folder.path() / ""));
  EXPECT_TRUE(isBelow(file, "/"));
  EXPECT_TRUE(isBelow(folder.path(), folder.path()));
  EXPECT_TRUE(isBelow(folder.path() / "a/not/there", folder.path() / "a"));
  EXPECT_FALSE(isBelow(folder.path() / "ab.sdf", folder.path() / "a"));
  EXPECT_FALSE(isBelow(folder.path() / "a/../c", folder.path() / "a"));
  EXPECT_FALSE(isBelow(file, folder.path() / "not there"));
  EXPECT_FALSE(isBelow(file, ""));
  EXPECT_FALSE(isBelow("", folder.path()));
}

TEST(IsBelow, FollowsLinks) {
  const test::TempFolder inner, outer;
  const fs::path file = outer.write("secret", "");
  fs::create_symlink(file, inner.path() / "file");
  fs::create_symlink(outer.path(), inner.path() / "folder");
  EXPECT_FALSE(isBelow(inner.path() / "file", inner.path()));
  EXPECT_FALSE(isBelow(inner.path() / "folder/secret", inner.path()));
  EXPECT_FALSE(isBelow(inner.path() / "folder/not there", inner.path()));
  EXPECT_TRUE(isBelow(inner.path() / "folder/secret", outer.path()));
  EXPECT_TRUE(isBelow(file, inner.path() / "folder"));
}

}  // namespace
}  // namespace pongsim::base
