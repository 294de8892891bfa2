#include "log/mcap/summary.hh"

#include <gtest/gtest.h>

#include "log/mcap/compression.hh"
#include "log/mcap/record_archive.hh"
#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class SummaryTest : public testing::Test {
 protected:
  SummaryTest() {
    samples::writeLog(path_, samples::someRecords(), {.chunkSize = 500});
    bytes_ = samples::bytesOf(path_);
  }
  /// @return What is wrong with the summary; nothing if it is valid or missing.
  std::string faultOf(const std::string& bytes) {
    std::string why;
    hasContents_ = contentsBySummary(InputFile(folder_.write("b.mcap", bytes)), why).has_value();
    return why;
  }
  /// @return The file with another footer, and with its checksum if that should be valid.
  std::string withFooter(const mcap::Footer& footer) const {
    const std::size_t size = mcap::kFooterSize + mcap::kMagic.size();
    std::string bytes = bytes_.substr(0, bytes_.size() - size);
    appendRecord(footer, bytes);
    return bytes + std::string(mcap::kMagic);
  }

  test::TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "a.mcap";
  std::string bytes_;
  bool hasContents_ = false;
};

TEST_F(SummaryTest, SaysWhatTheFileHas) {
  std::string why;
  const std::optional<Contents> contents = contentsBySummary(InputFile(path_), why);
  ASSERT_TRUE(contents) << why;
  EXPECT_EQ(contents->count, 200U);
  EXPECT_EQ(contents->counts, (std::map<std::uint16_t, std::uint64_t>{{1, 100}, {2, 100}}));
  EXPECT_EQ(contents->channels.at(2).topic, "/b");
  EXPECT_EQ(contents->schemas.at(1).name, "some.A");
  EXPECT_EQ(contents->endTime, 99'000U);
}

TEST_F(SummaryTest, MayBeMissing) {
  EXPECT_EQ(faultOf(bytes_.substr(0, bytes_.size() - 1)), "");
  EXPECT_FALSE(hasContents_);
  EXPECT_EQ(faultOf(withFooter({0, 0, 0})), "");
  EXPECT_FALSE(hasContents_);
  EXPECT_EQ(faultOf(""), "");
  EXPECT_FALSE(hasContents_);
}

TEST_F(SummaryTest, IsNotUsedWhereItIsDamagedOrLies) {
  std::string damaged = bytes_;
  damaged[damaged.size() - 60] ^= 1;
  EXPECT_NE(faultOf(damaged).find("its checksum is wrong"), std::string::npos);
  EXPECT_FALSE(hasContents_);
  // in the footer, beyond the end of the file, and in the middle of a chunk
  EXPECT_NE(faultOf(withFooter({bytes_.size(), 0, 0})).find("its summary can't be at byte"), std::string::npos);
  EXPECT_NE(faultOf(withFooter({~std::uint64_t{0}, 0, 0})).find("its summary can't be at byte"), std::string::npos);
  EXPECT_NE(faultOf(withFooter({100, 99, 0})).find("its summary can't be at byte"), std::string::npos);
  faultOf(withFooter({50, 0, 0}));
  EXPECT_FALSE(hasContents_);
}

}  // namespace
}  // namespace pongsim::log
