#include "log/playback/played_files.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "log/store/zip.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

class PlayedFilesTest : public testing::Test {
 protected:
  test::TempFolder folder_;
};

TEST_F(PlayedFilesTest, AreAFolderAFileOrAZipFileOfOne) {
  const fs::path state = folder_.write("rec/state.tlog", "a log");
  EXPECT_EQ(PlayedFiles(folder_.path() / "rec").stateFile(), state);
  EXPECT_EQ(PlayedFiles(state).stateFile(), state);
  packFolder(folder_.path() / "rec", folder_.path() / "other.zip");
  fs::path unpacked;
  {
    const PlayedFiles files(folder_.path() / "other.zip");
    unpacked = files.stateFile();
    EXPECT_EQ(unpacked.filename(), "state.tlog");
    EXPECT_EQ(fs::file_size(unpacked), 5U);
  }
  EXPECT_FALSE(fs::exists(unpacked.parent_path()));
}

TEST_F(PlayedFilesTest, AreMissedWhereThereIsNoRecording) {
  EXPECT_THROW(PlayedFiles(folder_.path() / "none"), Failure);
  EXPECT_THROW(PlayedFiles(folder_.path()), Failure);
  folder_.write("rec/other", "");
  packFolder(folder_.path() / "rec", folder_.path() / "rec.zip");
  EXPECT_THROW(PlayedFiles(folder_.path() / "rec.zip"), Failure);
  EXPECT_THROW(PlayedFiles(folder_.write("broken.zip", "PK and no more")), Failure);
}

TEST_F(PlayedFilesTest, HaveCopiesBelowTheirOwnFolder) {
  folder_.write("rec/state.tlog", "");
  const fs::path copy = folder_.write("rec/robots/wheel.dae", "");
  const PlayedFiles files(folder_.path() / "rec");
  EXPECT_EQ(files.placeOf("/robots/wheel.dae"), copy);
  EXPECT_EQ(files.placeOf("file:///robots/wheel.dae"), copy);
  for (const char* address :
       {"/robots/other.dae", "file:///robots/other.dae", "model://robot/wheel.dae", "wheel.dae", ""}) {
    EXPECT_EQ(files.placeOf(address), address);
  }
}

}  // namespace
}  // namespace pongsim::log
