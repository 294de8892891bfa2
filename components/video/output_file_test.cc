#include "video/output_file.hh"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "support/file_size_limit.hh"
#include "support/temp_folder.hh"

namespace pongsim::video {
namespace {

namespace fs = std::filesystem;

class VideoPlaces : public testing::Test {
 protected:
  std::string refusal(const fs::path& wanted) const { return placeOf(wanted, folder(), ".mp4").error; }
  fs::path folder() const { return root_.path() / "videos"; }

  test::TempFolder root_;
};

TEST_F(VideoPlaces, AreBelowTheFolder) {
  fs::create_directory(folder());
  EXPECT_EQ(placeOf("a.mp4", folder(), ".mp4").value, folder() / "a.mp4");
  EXPECT_EQ(placeOf("b/c/a.mp4", folder(), ".mp4").value, folder() / "b/c/a.mp4");
  EXPECT_EQ(placeOf(folder() / "a.mp4", folder(), ".mp4").value, folder() / "a.mp4");
  for (const fs::path& elsewhere : {fs::path("../a.mp4"), root_.path() / "a.mp4", fs::path("b/../../a.mp4"),
                                    root_.path() / "videos2/a.mp4", fs::path("/a.mp4")}) {
    EXPECT_EQ(refusal(elsewhere),
              "'" + elsewhere.string() + "' is not in '" + folder().string() + "', where videos are written");
  }
}

TEST_F(VideoPlaces, AreNotBehindLinksThatLeadElsewhere) {
  fs::create_directory(folder());
  fs::create_directory(root_.path() / "other");
  fs::create_directory_symlink(root_.path() / "other", folder() / "link");
  fs::create_symlink(root_.path() / "other/new.mp4", folder() / "new.mp4");
  EXPECT_NE(refusal("link/a.mp4").find("is not in"), std::string::npos);
  EXPECT_NE(refusal("new.mp4"), "");
}

TEST_F(VideoPlaces, AreNotTakenAndHaveTheFormatsEnding) {
  root_.write("videos/a.mp4", "precious");
  EXPECT_EQ(refusal("a.mp4"), "'a.mp4' is there already");
  EXPECT_EQ(refusal(".bashrc"), "'.bashrc' does not end in .mp4");
  EXPECT_EQ(refusal("a.avi"), "'a.avi' does not end in .mp4");
}

TEST(VideoFile, IsThereWhenItIsComplete) {
  const test::TempFolder folder;
  const fs::path place = folder.path() / "b/a.mp4";
  Outcome<OutputFile> file = OutputFile::create(place);
  ASSERT_TRUE(file) << file.error;
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  EXPECT_EQ(file->write(bytes), 3);
  EXPECT_EQ(file->seek(0, SEEK_SET), 0);
  EXPECT_EQ(file->write(bytes), 3);
  EXPECT_FALSE(fs::exists(place));
  EXPECT_TRUE(file->complete());
  EXPECT_EQ(fs::file_size(place), 3U);
  EXPECT_FALSE(fs::exists(place.string() + ".part"));
}

TEST(VideoFile, ReplacesNoFile) {
  const test::TempFolder folder;
  Outcome<OutputFile> file = OutputFile::create(folder.path() / "a.mp4");
  ASSERT_TRUE(file);
  folder.write("a.mp4", "precious");
  EXPECT_EQ(file->complete().error, "'" + (folder.path() / "a.mp4").string() + "' can't be written: File exists");
  EXPECT_EQ(fs::file_size(folder.path() / "a.mp4"), 8U);
}

TEST(VideoFile, IsRemovedWhereItIsNotComplete) {
  const test::TempFolder folder;
  { EXPECT_TRUE(OutputFile::create(folder.path() / "a.mp4")); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(VideoFile, SaysThatADiskIsFull) {
  const test::TempFolder folder;
  const test::FileSizeLimit full(2);
  Outcome<OutputFile> file = OutputFile::create(folder.path() / "a.mp4");
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  EXPECT_EQ(file->write(bytes), -EFBIG);
  EXPECT_EQ(file->complete().error, "'" + (folder.path() / "a.mp4").string() + "' can't be written: File too large");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace pongsim::video
