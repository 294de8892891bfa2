#include "log/store/zip.hh"

#include <gtest/gtest.h>
#include <zip.h>

#include <fstream>
#include <iterator>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ZipTest : public testing::Test {
 protected:
  /// Creates a zip file with an entry of that name.
  fs::path zipWith(const std::string& name) const {
    const fs::path file = folder_.path() / "other.zip";
    int error = 0;
    zip_t* const zip = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    zip_file_add(zip, name.c_str(), zip_source_buffer(zip, "x", 1, 0), 0);
    EXPECT_EQ(zip_close(zip), 0);
    return file;
  }
  /// @return The error message, or "".
  std::string refusalOf(const fs::path& zip) const {
    try {
      unpackZip(zip, out_);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  }

  test::TempFolder folder_;
  const fs::path zip_ = folder_.path() / "rec.zip", out_ = folder_.path() / "out";

  void SetUp() override { fs::create_directory(out_); }
};

TEST_F(ZipTest, HasAFolderWithAllThatIsInIt) {
  const std::string large(300'000, 'x');
  folder_.write("rec/state.tlog", large);
  folder_.write("rec/a/b/c.txt", "deep");
  fs::create_directory(folder_.path() / "rec/empty");
  folder_.write("rec.zip", "an old one");
  packFolder(folder_.path() / "rec", zip_);
  EXPECT_LT(fs::file_size(zip_), large.size() / 10);
  unpackZip(zip_, out_);
  EXPECT_EQ(contentOf(out_ / "rec/state.tlog"), large);
  EXPECT_EQ(contentOf(out_ / "rec/a/b/c.txt"), "deep");
  EXPECT_TRUE(fs::is_directory(out_ / "rec/empty"));
}

TEST_F(ZipTest, WithNamesThatLeadOutIsRefused) {
  for (const char* name : {"../evil", "/evil", "a/../../evil"}) {
    EXPECT_NE(refusalOf(zipWith(name)).find("leads out of its folder"), std::string::npos) << name;
    EXPECT_TRUE(fs::is_empty(out_)) << name;
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "evil"));
  EXPECT_EQ(refusalOf(zipWith("a/../fine")), "");
  EXPECT_EQ(contentOf(out_ / "fine"), "x");
}

TEST_F(ZipTest, ThatIsNoneOrDamagedIsRefused) {
  EXPECT_NE(refusalOf(folder_.write("text.zip", "I am a text")).find("can't be opened as a zip file"),
            std::string::npos);
  EXPECT_NE(refusalOf(folder_.path() / "none.zip").find("can't be opened as a zip file"), std::string::npos);
  folder_.write("rec/a", std::string(1000, 'a'));
  packFolder(folder_.path() / "rec", zip_);
  const std::string whole = contentOf(zip_);
  EXPECT_NE(refusalOf(folder_.write("cut.zip", whole.substr(0, whole.size() / 2))), "");
}

TEST_F(ZipTest, IsNotWrittenWhereItsFolderIsMissing) {
  folder_.write("rec/a", "a");
  EXPECT_THROW(packFolder(folder_.path() / "rec", folder_.path() / "none/rec.zip"), Failure);
}

TEST_F(ZipTest, IsRefusedIfItBecomesTooLargeOrTooMany) {
  folder_.write("rec/state.tlog", std::string(3'000'000, '\0'));
  folder_.write("rec/b", "x");
  packFolder(folder_.path() / "rec", zip_);
  const auto refusal = [&](const ZipLimits& limits) -> std::string {
    try {
      unpackZip(zip_, out_, limits);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({.free = 1000}),
            "the zip file was refused: its " + std::to_string(fs::file_size(zip_)) + " bytes would become 3000001");
  EXPECT_NE(refusal({.files = 1}).find("files, and 1 is the limit"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(out_));
  EXPECT_EQ(refusal({}), "");
}

TEST_F(ZipTest, UnpacksNoMoreThanItClaims) {
  folder_.write("rec/state.tlog", std::string(300'000, 'x'));
  packFolder(folder_.path() / "rec", zip_);
  std::string bytes = contentOf(zip_);
  // APPNOTE 4.3.12: the size in the entry's record of the directory, and, in 4.3.7, in its own head
  const std::string size("\xe0\x93\x04\x00", 4), less("\xe0\x93\x00\x00", 4);
  std::size_t changed = 0;
  for (std::size_t at = bytes.find(size); at != std::string::npos; at = bytes.find(size, at + 1), ++changed)
    bytes.replace(at, 4, less);
  ASSERT_EQ(changed, 2U);
  folder_.write("rec.zip", bytes);
  EXPECT_EQ(refusalOf(zip_), "the zip file is damaged where it has 'state.tlog'");
}

}  // namespace
}  // namespace pongsim::log
