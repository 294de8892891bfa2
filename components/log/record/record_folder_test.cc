#include "log/record/record_folder.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

class RecordFolderTest : public testing::Test {
 protected:
  test::TempFolder folder_;
  const fs::path wanted_ = folder_.path() / "rec";
};

TEST_F(RecordFolderTest, IsMadeWithAZipFileBesideIt) {
  const RecordFolder made = makeRecordFolder(folder_.path() / "a/b/../rec/", "", WhereTaken::kReplaceFiles);
  EXPECT_EQ(made.folder, folder_.path() / "a/rec");
  EXPECT_EQ(made.zip, folder_.path() / "a/rec.zip");
  EXPECT_TRUE(fs::is_directory(made.folder));
  const fs::path zip = folder_.path() / "x.zip";
  EXPECT_EQ(makeRecordFolder(wanted_, zip, WhereTaken::kReplaceFiles).zip, zip);
}

TEST_F(RecordFolderTest, OfARecordingThatIsThereIsTreatedAsAsked) {
  folder_.write("rec/old", "");
  folder_.write("rec(1).zip", "");
  EXPECT_EQ(makeRecordFolder(wanted_, "", WhereTaken::kReplaceFiles).folder, wanted_);
  EXPECT_TRUE(fs::exists(wanted_ / "old"));
  const RecordFolder another = makeRecordFolder(wanted_, "", WhereTaken::kTakeAnother);
  EXPECT_EQ(another.folder, folder_.path() / "rec(2)");
  EXPECT_EQ(another.zip, folder_.path() / "rec(2).zip");
  folder_.write("rec.zip", "");
  EXPECT_EQ(makeRecordFolder(wanted_, "", WhereTaken::kDelete).folder, wanted_);
  EXPECT_FALSE(fs::exists(wanted_ / "old"));
  EXPECT_FALSE(fs::exists(folder_.path() / "rec.zip"));
}

TEST_F(RecordFolderTest, TakesOneRecordingAtATime) {
  const RecordFolder first = makeRecordFolder(wanted_, "", WhereTaken::kReplaceFiles);
  folder_.write("rec/state.tlog", "being written");
  for (const WhereTaken where : {WhereTaken::kReplaceFiles, WhereTaken::kDelete}) {
    EXPECT_THROW(makeRecordFolder(wanted_, "", where), Failure);
  }
  EXPECT_TRUE(fs::exists(wanted_ / "state.tlog"));
}

TEST_F(RecordFolderTest, IsNotMadeWhereAFileIs) {
  folder_.write("rec", "");
  EXPECT_THROW(makeRecordFolder(wanted_, "", WhereTaken::kReplaceFiles), Failure);
  EXPECT_THROW(makeRecordFolder(wanted_ / "below", "", WhereTaken::kReplaceFiles), Failure);
}

}  // namespace
}  // namespace pongsim::log
