#include "log/mcap/merge.hh"

#include <gtest/gtest.h>

#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

constexpr std::uint64_t kEnd = 1'000'000;

class MergeTest : public testing::Test {
 protected:
  /// Writes one message per time, in chunks of one.
  void write(const std::vector<std::int64_t>& times) {
    std::vector<samples::Kept> records;
    for (const std::int64_t time : times) records.push_back({time, "/a", "some.A", std::to_string(time)});
    samples::writeLog(path_, records, {.chunkSize = 1});
  }
  /// @return The times of the selected messages, in the order in which they are returned.
  std::vector<std::uint64_t> timesOf(std::uint64_t from, std::uint64_t to, const Merge::IsWanted& isWanted) const {
    const InputFile file(path_);
    const Contents contents = contentsOf(file);
    Merge merge(file, contents.blocks, from, to, isWanted);
    std::vector<std::uint64_t> times;
    while (const auto message = merge.next()) {
      EXPECT_EQ(message->data, std::to_string(message->logTime));
      times.push_back(message->logTime);
    }
    return times;
  }

  test::TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "a.mcap";
};

TEST_F(MergeTest, HasTheOrderOfTimeWhateverThatOfTheChunks) {
  write({30, 10, 20, 40, 0});
  const auto all = [](std::uint16_t, std::uint64_t) { return true; };
  EXPECT_EQ(timesOf(0, kEnd, all), (std::vector<std::uint64_t>{0, 10, 20, 30, 40}));
  EXPECT_EQ(timesOf(0, kEnd, [](std::uint16_t, std::uint64_t time) { return time % 20 == 0; }),
            (std::vector<std::uint64_t>{0, 20, 40}));
  EXPECT_TRUE(timesOf(0, kEnd, [](std::uint16_t channel, std::uint64_t) { return channel != 1; }).empty());
}

TEST_F(MergeTest, DoesNotReadChunksOfOtherTimes) {
  write({10, 20, 30});
  std::string bytes = samples::bytesOf(path_);
  const Contents contents = contentsOf(InputFile(path_));
  // the first chunk is damaged
  bytes[contents.blocks[0].offset + contents.blocks[0].length - 1] ^= 1;
  folder_.write("a.mcap", bytes);
  const auto all = [](std::uint16_t, std::uint64_t) { return true; };
  EXPECT_EQ(timesOf(15, kEnd, all), (std::vector<std::uint64_t>{20, 30}));
  EXPECT_THROW(timesOf(0, kEnd, all), Failure);
}

}  // namespace
}  // namespace pongsim::log
