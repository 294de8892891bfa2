#include "log/mcap/chunk_builder.hh"

#include <gtest/gtest.h>

namespace pongsim::log {
namespace {

mcap::Message messageOf(std::uint16_t channel, std::uint64_t time) { return {channel, 0, time, time, "data"}; }

TEST(ChunkBuilder, KnowsWhereItsMessagesAreAndWhen) {
  ChunkBuilder chunk;
  EXPECT_TRUE(chunk.isEmpty());
  EXPECT_EQ(chunk.endTime(), 0U);
  chunk.add(mcap::Schema{1, "some.A", "", ""});
  chunk.add(mcap::Channel{7, 1, "/a", "", {}});
  // schemas and channels do not count as messages
  EXPECT_FALSE(chunk.isEmpty());
  EXPECT_TRUE(chunk.indexes().empty());
  for (const auto& [channel, time] : {std::pair(7, 30), std::pair(8, 20), std::pair(7, 40)}) {
    chunk.add(messageOf(static_cast<std::uint16_t>(channel), static_cast<std::uint64_t>(time)));
  }
  EXPECT_EQ(chunk.startTime(), 20U);
  EXPECT_EQ(chunk.endTime(), 40U);
  ASSERT_EQ(chunk.indexes().size(), 2U);
  const mcap::MessageIndex& index = chunk.indexes().at(7);
  EXPECT_EQ(index.channelId, 7);
  ASSERT_EQ(index.entries.size(), 2U);
  for (const auto& [time, offset] : index.entries) {
    std::string wanted;
    appendRecord(messageOf(7, time), wanted);
    EXPECT_EQ(chunk.records().substr(offset, wanted.size()), wanted);
  }
}

}  // namespace
}  // namespace pongsim::log
