#include "log/mcap/output_file.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class OutputFileTest : public testing::Test {
 protected:
  test::TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "a";
};

TEST_F(OutputFileTest, HasWhatIsWrittenAtOnce) {
  OutputFile file(path_, false);
  file.write("abc");
  EXPECT_EQ(samples::bytesOf(path_), "abc");
  file.write("");
  file.write("de");
  EXPECT_EQ(samples::bytesOf(path_), "abcde");
  EXPECT_EQ(file.size(), 5U);
  EXPECT_EQ(file.path(), path_);
}

TEST_F(OutputFileTest, OverwritesOnlyWhereItIsToldTo) {
  folder_.write("a", "an old and longer text");
  EXPECT_THROW(OutputFile(path_, false), Failure);
  EXPECT_EQ(samples::bytesOf(path_), "an old and longer text");
  OutputFile(path_, true).write("new");
  EXPECT_EQ(samples::bytesOf(path_), "new");
}

TEST_F(OutputFileTest, SaysWhyItCannotBeWritten) {
  EXPECT_THROW(OutputFile(folder_.path() / "none/a", false), Failure);
  OutputFile full("/dev/full", true);
  try {
    full.write("abc");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "'/dev/full' can't be written: No space left on device");
    EXPECT_EQ(failure.hint(), "free disk space; what has been written is readable");
  }
  EXPECT_EQ(full.size(), 0U);
}

TEST_F(OutputFileTest, TakesNothingWhenItIsClosed) {
  OutputFile file(path_, false);
  file.write("abc");
  file.close();
  EXPECT_EQ(samples::bytesOf(path_), "abc");
  EXPECT_THROW(file.write("d"), Failure);
}

}  // namespace
}  // namespace pongsim::log
