#include "log/record/folder_lock.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

TEST(FolderLock, IsHadByOneAtATime) {
  const test::TempFolder folder;
  std::optional<FolderLock> first = FolderLock::take(folder.path());
  ASSERT_TRUE(first);
  EXPECT_FALSE(FolderLock::take(folder.path()));
  const FolderLock moved = *std::move(first);
  first.reset();
  EXPECT_FALSE(FolderLock::take(folder.path()));
}

TEST(FolderLock, IsThereAgainWhenItsOwnerIsGone) {
  const test::TempFolder folder;
  FolderLock::take(folder.path()).reset();
  EXPECT_TRUE(FolderLock::take(folder.path()));
}

}  // namespace
}  // namespace pongsim::log
