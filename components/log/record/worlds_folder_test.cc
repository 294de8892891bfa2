#include "log/record/worlds_folder.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

TEST(WorldsFolder, IsOneForAllWhoJoinAndANewOneForWhoComesLater) {
  const test::TempFolder place;
  const std::string wanted = place.path() / "rec";
  auto first = WorldsFolder::join(wanted, "", WhereTaken::kTakeAnother);
  auto second = WorldsFolder::join(wanted, "", WhereTaken::kTakeAnother);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first->folderOf("a").folder, fs::path(wanted) / "a");
  EXPECT_EQ(second->folderOf("b").folder, fs::path(wanted) / "b");
  WorldsFolder::leave(std::move(first), false);
  EXPECT_EQ(WorldsFolder::join(wanted, "", WhereTaken::kTakeAnother), second);
  WorldsFolder::leave(std::move(second), false);
  auto later = WorldsFolder::join(wanted, "", WhereTaken::kTakeAnother);
  EXPECT_EQ(later->folderOf("a").folder, fs::path(wanted + "(1)") / "a");
}

TEST(WorldsFolder, KeepsAWorldsFolderForOneAtATime) {
  const test::TempFolder place;
  const auto worlds = WorldsFolder::join(place.path() / "rec", "", WhereTaken::kReplaceFiles);
  const RecordFolder first = worlds->folderOf("a");
  EXPECT_THROW(worlds->folderOf("a"), Failure);
}

TEST(WorldsFolder, HasNoWorldOutsideItself) {
  const test::TempFolder place;
  const fs::path rec = place.path() / "rec";
  const auto worlds = WorldsFolder::join(rec, "", WhereTaken::kReplaceFiles);
  for (const char* name : {"../out", "..", ".", "a/b"})
    EXPECT_EQ(worlds->folderOf(name).folder.parent_path(), rec) << name;
}

TEST(WorldsFolder, IsPackedByTheLastOne) {
  const test::TempFolder place;
  const fs::path rec = place.path() / "rec";
  auto first = WorldsFolder::join(rec, "", WhereTaken::kDelete);
  auto second = WorldsFolder::join(rec, "", WhereTaken::kDelete);
  std::ofstream(first->folderOf("a").folder / "file") << "text";
  WorldsFolder::leave(std::move(first), true);
  EXPECT_TRUE(fs::is_directory(rec));
  WorldsFolder::leave(std::move(second), true);
  EXPECT_FALSE(fs::exists(rec));
  EXPECT_TRUE(fs::is_regular_file(rec.string() + ".zip"));
}

TEST(WorldsFolder, IsPackedByOneOfThoseWhoLeaveAtTheSameTime) {
  const test::TempFolder place;
  for (int i = 0; i < 20; ++i) {
    const fs::path rec = place.path() / ("rec" + std::to_string(i));
    auto first = WorldsFolder::join(rec, "", WhereTaken::kDelete);
    auto second = WorldsFolder::join(rec, "", WhereTaken::kDelete);
    std::ofstream(first->folderOf("a").folder / "file") << "text";
    std::thread other([&second] { WorldsFolder::leave(std::move(second), true); });
    WorldsFolder::leave(std::move(first), true);
    other.join();
    EXPECT_FALSE(fs::exists(rec));
    EXPECT_TRUE(fs::is_regular_file(rec.string() + ".zip"));
  }
}

}  // namespace
}  // namespace pongsim::log
