#include "log/mcap/mcap_writer.hh"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"
#include "support/wait_until.hh"

namespace pongsim::log {
namespace {

using samples::Kept;

class McapWriterTest : public testing::Test {
 protected:
  pongsim::test::TempFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

TEST_F(McapWriterTest, WritesWhatIsReadAgain) {
  const std::vector<Kept> records = samples::someRecords();
  for (const Compression each : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    for (const std::size_t chunkSize : {1U, 500U, 10'000'000U}) {
      samples::writeLog(file_, records, {.compression = each, .chunkSize = chunkSize});
      const McapReader reader(file_);
      EXPECT_EQ(samples::readLog(reader), records);
      EXPECT_EQ(reader.torn(), std::nullopt);
      EXPECT_EQ(reader.topics(), (std::vector<Topic>{{"/a", "some.A", 100}, {"/b", "some.B", 100}}));
      EXPECT_EQ(reader.timeRange(), (TimeRange{0, 99'000}));
      EXPECT_EQ(reader.definition("/a", "some.A"), samples::someDefinition("/a", "some.A"));
      EXPECT_EQ(reader.packing().chunks, chunkSize == 1 ? 200U : chunkSize == 500 ? reader.packing().chunks : 1U);
    }
  }
}

TEST_F(McapWriterTest, WritesALogWithoutMessages) {
  samples::writeLog(file_, {});
  const McapReader reader(file_);
  EXPECT_TRUE(reader.topics().empty());
  EXPECT_EQ(reader.timeRange(), std::nullopt);
  EXPECT_EQ(reader.torn(), std::nullopt);
}

TEST_F(McapWriterTest, HasAMessageInTheFileSoonAfterwards) {
  McapWriter writer(file_, {}, samples::someDefinition);
  writer.write(Kept{5, "/a", "some.A", "x"}.record());
  EXPECT_TRUE(pongsim::test::waitUntil([this] { return samples::readLog(McapReader(file_)).size() == 1; }));
  writer.write(Kept{6, "/a", "some.A", "y"}.record());
  EXPECT_TRUE(pongsim::test::waitUntil([this] { return samples::readLog(McapReader(file_)).size() == 2; }));
  EXPECT_NE(McapReader(file_).torn().value_or("").find("truncated"), std::string::npos);
}

TEST_F(McapWriterTest, OverwritesOnlyWhereItIsToldTo) {
  samples::writeLog(file_, samples::someRecords());
  EXPECT_THROW(McapWriter(file_, {}, samples::someDefinition), Failure);
  EXPECT_EQ(samples::readLog(McapReader(file_)).size(), 200U);
  EXPECT_THROW(McapWriter(folder_.path() / "no" / "a.mcap", {}, samples::someDefinition), Failure);
}

/// Limits the size of files while it exists.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t size) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(McapWriterTest, KeepsWhatItWroteWhereThereIsNoMoreRoom) {
  EXPECT_THROW(McapWriter("/dev/full", {.overwrites = true}, samples::someDefinition), Failure);
  const SizeLimit limit(4000);
  McapWriter writer(file_, {.compression = Compression::kNone, .chunkSize = 200, .queueSize = 200},
                    samples::someDefinition);
  const auto writeMany = [&writer] {
    for (int i = 0; i < 100'000; ++i) writer.write(Kept{i, "/a", "some.A", "x"}.record());
  };
  EXPECT_THROW(writeMany(), Failure);
  EXPECT_THROW(writer.write(Kept{1, "/a", "some.A", "x"}.record()), Failure);
  EXPECT_THROW(writer.close(), Failure);
  EXPECT_GT(samples::readLog(McapReader(file_)).size(), 10U);
}

TEST_F(McapWriterTest, TakesNoTimesBeforeZero) {
  McapWriter writer(file_, {}, samples::someDefinition);
  EXPECT_THROW(writer.write(Kept{-1, "/a", "some.A", "x"}.record()), Failure);
  writer.close();
  EXPECT_TRUE(samples::readLog(McapReader(file_)).empty());
}

}  // namespace
}  // namespace pongsim::log
