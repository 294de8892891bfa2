#include "log/mcap/input_file.hh"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class InputFileTest : public testing::Test {
 protected:
  static std::string refusal(const std::filesystem::path& path) {
    try {
      const InputFile file(path);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  }
  static std::string failureAt(const InputFile& file, std::uint64_t offset, std::uint64_t length) {
    try {
      file.read(offset, length);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  }

  test::TempFolder folder_;
};

TEST_F(InputFileTest, IsReadHereAndThere) {
  const InputFile file(folder_.write("a", "0123456789"));
  EXPECT_EQ(file.size(), 10U);
  EXPECT_EQ(file.read(3, 4), "3456");
  EXPECT_EQ(file.read(0, 10), "0123456789");
  EXPECT_EQ(file.read(10, 0), "");
}

TEST_F(InputFileTest, IsAsLongAsItWasWhenItWasOpened) {
  const std::filesystem::path path = folder_.write("a", "0123456789");
  const InputFile file(path);
  std::ofstream(path, std::ios::app) << "more";
  EXPECT_EQ(file.size(), 10U);
  EXPECT_EQ(failureAt(file, 8, 4), "byte 8: 4 bytes expected here, but the file ends at 10");
  std::filesystem::resize_file(path, 5);
  EXPECT_EQ(failureAt(file, 4, 3), "byte 5: the file has shrunk");
}

TEST_F(InputFileTest, IsNotReadBeyondItsEnd) {
  const InputFile file(folder_.write("a", "0123456789"));
  for (const std::uint64_t offset : {std::uint64_t{8}, std::uint64_t{11}, ~std::uint64_t{0}}) {
    EXPECT_NE(failureAt(file, offset, 3), "");
  }
  EXPECT_NE(failureAt(file, 1, ~std::uint64_t{0}), "");
}

TEST_F(InputFileTest, IsAPlainFile) {
  EXPECT_NE(refusal(folder_.path()).find("it is a folder"), std::string::npos);
  // it does not wait for a writer
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  EXPECT_NE(refusal(folder_.path() / "pipe").find("it is not a regular file"), std::string::npos);
  EXPECT_NE(refusal(folder_.path() / "none").find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::log
