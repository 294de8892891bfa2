#include "log/tlog/tlog_reader.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "log/store/failure.hh"
#include "log/tlog/tlog_writer.hh"
#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class TlogReaderTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.path() / "state.tlog"; }

  /// @return The payloads of the records, concatenated.
  static std::string payloads(const TlogReader& reader, const Selection& selection) {
    std::string text;
    reader.forEach(selection, [&](const Record& record) {
      text += record.payload;
      return true;
    });
    return text;
  }

  void write(const std::vector<Record>& records) {
    TlogWriter writer(file());
    for (const Record& record : records) writer.write(record);
    writer.close();
  }

  test::TempFolder folder_;
};

TEST_F(TlogReaderTest, GivesRecordsInTheOrderOfTime) {
  write({{3, "/a", "A", "c"}, {1, "/b", "B", "a"}, {3, "/b", "B", "d"}, {2, "/a", "A", "b"}});
  const TlogReader reader(file());
  EXPECT_EQ(payloads(reader, {}), "abcd");
  EXPECT_EQ(payloads(reader, {.from = 2, .to = 2}), "b");
  EXPECT_EQ(payloads(reader, {.topics = std::vector<std::string>{"/b"}}), "ad");
  EXPECT_EQ(payloads(reader, {.topics = std::vector<std::string>{}}), "");
  EXPECT_EQ(reader.timeRange(), (TimeRange{1, 3}));
  EXPECT_EQ(reader.topics(), (std::vector<Topic>{{"/a", "A", 2}, {"/b", "B", 2}}));
  EXPECT_FALSE(reader.torn());
}

TEST_F(TlogReaderTest, AnEmptyLogHasNoTimes) {
  write({});
  EXPECT_FALSE(TlogReader(file()).timeRange());
}

TEST_F(TlogReaderTest, ReadsWhatIsThereOfAFileThatIsCutOff) {
  std::vector<Record> records;
  const std::string payload(1000, 'x');
  for (std::int64_t i = 0; i < 500; ++i) records.push_back({i, "/a", "A", payload});
  write(records);
  std::filesystem::resize_file(file(), std::filesystem::file_size(file()) / 2);
  const TlogReader reader(file());
  ASSERT_TRUE(reader.torn());
  EXPECT_NE(reader.torn()->find("truncated"), std::string::npos);
  const std::size_t count = payloads(reader, {}).size() / payload.size();
  EXPECT_GT(count, 100U);
  EXPECT_LT(count, 400U);
}

TEST_F(TlogReaderTest, RefusesWhatIsNoLog) {
  std::ofstream(file()) << "this is a text, of more than a few letters";
  EXPECT_THROW(TlogReader{file()}, Failure);
  EXPECT_THROW(TlogReader{folder_.path()}, Failure);
  EXPECT_THROW(TlogReader{folder_.path() / "none"}, Failure);
}

TEST_F(TlogReaderTest, ReadsFortresssLog) {
  const std::optional<std::filesystem::path> data = test::goldenData();
  if (!data) GTEST_SKIP() << "no recordings of Fortress here";
  const std::filesystem::path golden = *data / "log/double_pendulum.tlog";
  const TlogReader reader(golden);
  EXPECT_EQ(reader.timeRange(), (TimeRange{1'000'000, 3'000'000'000}));
  EXPECT_EQ(reader.topics(),
            (std::vector<Topic>{{"/.ignition/sdf", "ignition.msgs.StringMsg", 1},
                                {"/world/log_pendulum/changed_state", "ignition.msgs.SerializedStateMap", 3000}}));
}

}  // namespace
}  // namespace pongsim::log
