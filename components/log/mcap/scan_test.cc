#include "log/mcap/scan.hh"

#include <gtest/gtest.h>

#include "log/mcap/summary.hh"
#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class ScanTest : public testing::Test {
 protected:
  ScanTest() { samples::writeLog(path_, samples::someRecords(), {.chunkSize = 500}); }

  test::TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "a.mcap";
};

TEST_F(ScanTest, FindsWhatTheSummarySays) {
  const InputFile file(path_);
  std::string why;
  const std::optional<Contents> summary = contentsBySummary(file, why);
  ASSERT_TRUE(summary) << why;
  const Contents scanned = contentsByScan(file);
  EXPECT_EQ(scanned.torn, std::nullopt);
  EXPECT_EQ(scanned.schemas, summary->schemas);
  EXPECT_EQ(scanned.channels, summary->channels);
  EXPECT_EQ(scanned.counts, summary->counts);
  EXPECT_EQ(scanned.count, summary->count);
  EXPECT_EQ(scanned.startTime, summary->startTime);
  EXPECT_EQ(scanned.endTime, summary->endTime);
  ASSERT_EQ(scanned.blocks.size(), summary->blocks.size());
  for (std::size_t i = 0; i < scanned.blocks.size(); ++i) {
    const Block &one = scanned.blocks[i], &other = summary->blocks[i];
    EXPECT_EQ(std::tie(one.offset, one.length, one.startTime, one.endTime, one.compression, one.uncompressedSize),
              std::tie(other.offset, other.length, other.startTime, other.endTime, other.compression,
                       other.uncompressedSize));
  }
}

TEST_F(ScanTest, EndsWhereTheFileIsCutOff) {
  const std::string bytes = samples::bytesOf(path_);
  const Contents whole = contentsByScan(InputFile(path_));
  const Block& third = whole.blocks.at(2);
  const auto contentsOfFirst = [&](std::uint64_t size) {
    return contentsByScan(InputFile(folder_.write("cut.mcap", bytes.substr(0, size))));
  };
  const Contents inThird = contentsOfFirst(third.offset + third.length - 1);
  EXPECT_EQ(inThird.blocks.size(), 2U);
  EXPECT_EQ(inThird.torn,
            "byte " + std::to_string(third.offset) + ": it is truncated: a chunk that begins here is incomplete");
  const Contents behindThird = contentsOfFirst(third.offset + third.length);
  EXPECT_EQ(behindThird.blocks.size(), 3U);
  EXPECT_EQ(behindThird.torn,
            "byte " + std::to_string(third.offset + third.length) + ": it is truncated: it has no footer");
}

TEST_F(ScanTest, TakesNothingOfAChunkThatIsDamaged) {
  const Contents whole = contentsByScan(InputFile(path_));
  std::string bytes = samples::bytesOf(path_);
  bytes[whole.blocks.at(1).offset + whole.blocks[1].length - 1] ^= 1;
  const Contents damaged = contentsByScan(InputFile(folder_.write("damaged.mcap", bytes)));
  EXPECT_EQ(damaged.blocks.size(), 1U);
  EXPECT_LT(damaged.count, whole.count);
  EXPECT_NE(damaged.torn.value_or("").find("the rest is ignored"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::log
