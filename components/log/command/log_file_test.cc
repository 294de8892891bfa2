#include "log/command/log_file.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "log/tlog/tlog_writer.hh"
#include "shared/program/failure.hh"
#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class LogFileTest : public testing::Test {
 protected:
  test::TempFolder folder_;
};

TEST_F(LogFileTest, IsKnownByItsBytesWhateverItsName) {
  const std::filesystem::path mcap = folder_.path() / "mcap.tlog", tlog = folder_.path() / "tlog.mcap";
  samples::writeLog(mcap, samples::someRecords());
  TlogWriter(tlog).close();
  EXPECT_EQ(LogFile(mcap).format(), Format::kMcap);
  EXPECT_NE(LogFile(mcap).mcap(), nullptr);
  EXPECT_EQ(LogFile(tlog).format(), Format::kTlog);
  EXPECT_EQ(LogFile(tlog).mcap(), nullptr);
  EXPECT_THROW(LogFile(folder_.write("text.mcap", "I am a text")), Failure);
  EXPECT_THROW(LogFile(folder_.path() / "none.mcap"), Failure);
}

TEST_F(LogFileTest, SaysOfATlogThatItsMessagesAreProtobuf) {
  const std::filesystem::path mcap = folder_.path() / "a.mcap", tlog = folder_.path() / "a.tlog";
  samples::writeLog(mcap, samples::someRecords());
  TlogWriter(tlog).close();
  EXPECT_EQ(LogFile(mcap).definition("/a", "some.A"), samples::someDefinition("/a", "some.A"));
  EXPECT_EQ(LogFile(tlog).definition("/a", "ignition.msgs.Twist"), protobufDefinition("ignition.msgs.Twist"));
}

TEST_F(LogFileTest, FindsATopicWithoutItsSlashAndNamesTheNearest) {
  const std::filesystem::path file = folder_.path() / "a.mcap";
  samples::writeLog(file, {{1, "/clock", "some.A", "x"}});
  const LogFile log(file);
  EXPECT_EQ(requireTopic(log.reader(), "a.mcap", "/clock"), "/clock");
  EXPECT_EQ(requireTopic(log.reader(), "a.mcap", "clock"), "/clock");
  for (const auto& [topic, hint] :
       {std::pair("/clok", "did you mean '/clock'?"), std::pair("/something", "pongsim log info a.mcap lists them")}) {
    try {
      requireTopic(log.reader(), "a.mcap", topic);
      FAIL();
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.hint(), hint);
    }
  }
}

TEST(LogFile, KnowsFormatsAndCompressionsByName) {
  EXPECT_EQ(formatOf("a.b/c.mcap"), Format::kMcap);
  EXPECT_EQ(formatOf("state.tlog"), Format::kTlog);
  for (const char* name : {"", "mcap", ".mcap", "a.MCAP", "a.mcap.zst"})
    EXPECT_THROW(formatOf(name), cli::UsageError) << name;
  EXPECT_EQ(compressionFrom("none"), Compression::kNone);
  EXPECT_EQ(compressionFrom("lz4"), Compression::kLz4);
  EXPECT_EQ(compressionFrom("zstd"), Compression::kZstd);
  // MCAP does not define it
  for (const char* name : {"", "gzip"}) EXPECT_THROW(compressionFrom(name), cli::UsageError) << name;
}

}  // namespace
}  // namespace pongsim::log
