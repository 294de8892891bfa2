#include "log/mcap/mcap_reader.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>

#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

using samples::Kept;

class McapReaderTest : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& bytes) const { return folder_.write("damaged.mcap", bytes); }
  std::string bytesOfSome(const McapOptions& options = {.chunkSize = 700}) const {
    const std::filesystem::path file = folder_.path() / "whole.mcap";
    samples::writeLog(file, samples::someRecords(), options);
    return samples::bytesOf(file);
  }

  pongsim::test::TempFolder folder_;
};

TEST_F(McapReaderTest, GivesMessagesInTheOrderOfTime) {
  std::vector<Kept> records = samples::someRecords();
  std::mt19937 random(3);
  std::ranges::shuffle(records, random);
  const std::filesystem::path file = folder_.path() / "a.mcap";
  samples::writeLog(file, records, {.chunkSize = 200});
  const std::vector<Kept> read = samples::readLog(McapReader(file));
  EXPECT_EQ(read.size(), records.size());
  std::ranges::stable_sort(records, {}, &Kept::timeNs);
  EXPECT_EQ(read, records);
}

TEST_F(McapReaderTest, GivesWhatIsSelected) {
  const McapReader reader(write(bytesOfSome()));
  const std::vector<Kept> read =
      samples::readLog(reader, {.from = 10'000, .to = 12'000, .topics = std::vector<std::string>{"/b"}});
  EXPECT_EQ(read,
            (std::vector<Kept>{
                {10'000, "/b", "some.B", "b10"}, {11'000, "/b", "some.B", "b11"}, {12'000, "/b", "some.B", "b12"}}));
  EXPECT_TRUE(samples::readLog(reader, {.from = -5, .to = -1}).empty());
  std::size_t count = 0;
  reader.forEach({}, [&count](const Record&) { return ++count < 3; });
  EXPECT_EQ(count, 3U);
}

TEST_F(McapReaderTest, ReadsUpToWhereAFileIsCutOff) {
  const std::string whole = bytesOfSome();
  const std::vector<Kept> records = samples::someRecords();
  std::size_t longest = 0;
  for (std::size_t size = 8; size < whole.size(); size += 13) {
    const McapReader reader(write(whole.substr(0, size)));
    const std::vector<Kept> read = samples::readLog(reader);
    // the rest is the beginning of the file
    ASSERT_LE(read.size(), records.size());
    EXPECT_TRUE(std::ranges::equal(read, std::span(records).first(read.size()))) << size;
    EXPECT_GE(read.size(), longest);
    longest = read.size();
    EXPECT_TRUE(read.size() == records.size() || reader.torn()) << size;
  }
  EXPECT_EQ(longest, records.size());
}

TEST_F(McapReaderTest, NeverGivesWhatWasNotWrittenAndNeverCrashes) {
  const std::vector<Kept> records = samples::someRecords();
  std::mt19937 random(1);
  int failed = 0, torn = 0;
  for (const Compression compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    const std::string whole = bytesOfSome({.compression = compression, .chunkSize = 700});
    for (int i = 0; i < 700; ++i) {
      std::string bytes = whole;
      const int changes = 1 + i % 3;
      for (int j = 0; j < changes; ++j) bytes[random() % bytes.size()] = static_cast<char>(random());
      std::vector<Kept> read;
      try {
        const McapReader reader(write(bytes));
        torn += reader.torn() ? 1 : 0;
        read = samples::readLog(reader);
      } catch (const Failure& failure) {
        ++failed;
        EXPECT_NE(std::string(failure.what()).find("damaged.mcap"), std::string::npos);
      }
      ASSERT_LE(read.size(), records.size());
    }
  }
  EXPECT_GT(failed, 100);
  EXPECT_GT(torn, 100);
}

TEST_F(McapReaderTest, SaysWhereAChunkIsDamaged) {
  std::string bytes = bytesOfSome({.compression = Compression::kNone, .chunkSize = 700});
  const std::size_t place = bytes.find("b50");
  bytes[place] = 'c';
  const std::string failure = samples::failureOf(write(bytes));
  EXPECT_NE(failure.find("damaged.mcap' can't be read: byte "), std::string::npos) << failure;
  EXPECT_NE(failure.find("its checksum is wrong"), std::string::npos) << failure;
}

TEST_F(McapReaderTest, ReadsAllWhereTheIndexIsDamaged) {
  std::string bytes = bytesOfSome();
  // within the summary
  bytes[bytes.size() - 60] ^= 1;
  const McapReader reader(write(bytes));
  EXPECT_EQ(samples::readLog(reader), samples::someRecords());
  EXPECT_NE(reader.torn().value_or("").find("no message is missing"), std::string::npos);
}

TEST_F(McapReaderTest, ReadsRecordsOutsideOfChunksWithoutASummary) {
  std::string bytes(mcap::kMagic);
  appendRecord(mcap::Header{"", "somebody"}, bytes);
  appendRecord(mcap::Schema{1, "some.A", "protobuf", "x"}, bytes);
  appendRecord(mcap::Channel{7, 1, "/a", "protobuf", {}}, bytes);
  for (std::uint64_t i = 0; i < 3; ++i) {
    appendRecord(mcap::Message{7, 0, 30 - i, 0, "data"}, bytes);
  }
  appendRecord(mcap::DataEnd{}, bytes);
  appendRecord(mcap::Footer{}, bytes);
  const McapReader reader(write(bytes + std::string(mcap::kMagic)));
  EXPECT_EQ(reader.torn(), std::nullopt);
  EXPECT_EQ(reader.library(), "somebody");
  EXPECT_EQ(
      samples::readLog(reader),
      (std::vector<Kept>{{28, "/a", "some.A", "data"}, {29, "/a", "some.A", "data"}, {30, "/a", "some.A", "data"}}));
}

TEST_F(McapReaderTest, SaysWhatIsNoMcap) {
  for (const std::string& bytes : {std::string(), std::string("hello, I am a text"), std::string(1000, '\0')}) {
    EXPECT_NE(samples::failureOf(write(bytes)).find("not an MCAP file"), std::string::npos);
  }
  EXPECT_NE(samples::failureOf(folder_.path()).find("it is a folder"), std::string::npos);
  EXPECT_NE(samples::failureOf(folder_.path() / "none.mcap").find("No such file"), std::string::npos);
}

TEST_F(McapReaderTest, IsNotBlownUpByAChunk) {
  // 100 MiB of zeros in some kilobytes, with a claimed size of 4 exabytes, or of 1 kB
  const std::string zeros(std::size_t{100} << 20U, '\0');
  Packer packer(Compression::kZstd);
  const std::string packed(packer.pack(zeros));
  for (const std::uint64_t claim : {std::uint64_t{1} << 62U, std::uint64_t{1000}}) {
    std::string bytes(mcap::kMagic);
    appendRecord(mcap::Header{}, bytes);
    appendRecord(mcap::Chunk{0, 0, claim, 0, "zstd", packed}, bytes);
    const McapReader reader(write(bytes));
    EXPECT_NE(reader.torn().value_or("").find("the chunk is damaged"), std::string::npos);
    EXPECT_TRUE(reader.topics().empty());
  }
}

}  // namespace
}  // namespace pongsim::log
