#include "log/tlog/tlog_writer.hh"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "log/store/failure.hh"
#include "log/tlog/database.hh"
#include "log/tlog/tlog_reader.hh"
#include "support/file_size_limit.hh"
#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"
#include "support/wait_until.hh"

namespace pongsim::log {
namespace {

constexpr const char* kType = "ignition.msgs.Int32";

/// @return Name and type of each column of each table: "topics.name TEXT".
std::vector<std::string> columnsOf(const std::filesystem::path& file) {
  const Database database("file:" + file.string() + "?mode=ro", file, Database::Access::kRead);
  Statement rows(database,
                 "SELECT m.name || '.' || c.name || ' ' || c.type || ' ' || c.\"notnull\" FROM sqlite_master m, "
                 "pragma_table_info(m.name) c WHERE m.type = 'table' ORDER BY 1");
  std::vector<std::string> columns;
  while (rows.step()) columns.emplace_back(rows.text(0));
  return columns;
}

class TlogWriterTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.path() / "state.tlog"; }

  std::size_t countIn(const std::filesystem::path& log) const {
    std::size_t count = 0;
    TlogReader(log).forEach({}, [&](const Record&) {
      ++count;
      return true;
    });
    return count;
  }

  test::TempFolder folder_;
};

TEST_F(TlogWriterTest, ItsFilesHaveTheTablesOfFortresss) {
  const std::optional<std::filesystem::path> data = test::goldenData();
  if (!data) GTEST_SKIP() << "no recordings of Fortress here";
  const std::filesystem::path golden = *data / "log/double_pendulum.tlog";
  TlogWriter(file()).close();
  EXPECT_EQ(columnsOf(file()), columnsOf(golden));
}

TEST_F(TlogWriterTest, LeavesOneFile) {
  TlogWriter writer(file());
  writer.write({1, "/a", kType, "x"});
  writer.close();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  EXPECT_FALSE(TlogReader(file()).torn());
}

TEST_F(TlogWriterTest, ReplacesAFile) {
  for (int i = 0; i < 2; ++i) {
    TlogWriter writer(file());
    writer.write({1, "/a", kType, "x"});
    writer.close();
  }
  EXPECT_EQ(countIn(file()), 1U);
}

TEST_F(TlogWriterTest, AMessageWithoutBytesIsOne) {
  TlogWriter writer(file());
  writer.write({1, "/a", kType, {}});
  writer.close();
  EXPECT_EQ(countIn(file()), 1U);
}

TEST_F(TlogWriterTest, SaysThatItsFolderIsNotThere) {
  try {
    TlogWriter writer(folder_.path() / "none/state.tlog");
    FAIL();
  } catch (const Failure& why) {
    EXPECT_NE(std::string(why.what()).find("none/state.tlog"), std::string::npos) << why.what();
  }
}

TEST_F(TlogWriterTest, OfAKilledRecorderAllButTheLastSecondIsThere) {
  const pid_t child = fork();
  if (child == 0) {
    TlogWriter writer(file());
    for (std::int64_t i = 0;; ++i) {
      writer.write({i, "/a", kType, std::to_string(i)});
      usleep(1000);
    }
  }
  std::size_t seen = 0;
  test::waitUntil([&] {
    try {
      seen = countIn(file());
    } catch (const Failure&) {
      // not there yet
    }
    return seen > 0;
  });
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const TlogReader reader(file());
  EXPECT_TRUE(reader.torn());
  std::int64_t next = 0;
  reader.forEach({}, [&](const Record& record) {
    EXPECT_EQ(record.payload, std::to_string(next++));
    return true;
  });
  EXPECT_GE(next, static_cast<std::int64_t>(seen));
}

/// Writes until that fails.
/// @return The error.
std::string writeUntilFull(const std::filesystem::path& file) {
  TlogWriter writer(file);
  const std::string payload(10000, 'x');
  try {
    // as fast as possible: the disk is full before the time of a transaction is over
    for (std::int64_t i = 0;; ++i) writer.write({i, "/a", kType, payload});
  } catch (const Failure& why) {
    return why.what();
  }
}

TEST_F(TlogWriterTest, OnAFullDiskSaysSoAndKeepsWhatItHas) {
  std::string said;
  {
    const test::FileSizeLimit full(3'000'000);
    said = writeUntilFull(file());
  }
  const std::size_t kept = countIn(file());
  // all but a transaction of 1 MiB, and what SQLite adds
  EXPECT_GT(kept, 100U);
  EXPECT_EQ(said, "'" + file().string() + "' can't be written: disk I/O error; " + std::to_string(kept) +
                      " messages are kept");
}

}  // namespace
}  // namespace pongsim::log
