#include "log/tlog/database.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class DatabaseTest : public testing::Test {
 protected:
  /// @return What is said, and the hint.
  static std::string refusal(const auto& work) {
    try {
      work();
    } catch (const Failure& failure) {
      return std::string(failure.what()) + " (" + failure.hint() + ")";
    }
    return "";
  }

  test::TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "a.tlog";
};

TEST_F(DatabaseTest, GivesBackWhatItWasGiven) {
  {
    const Database database(path_.string(), path_, Database::Access::kCreate);
    database.run("CREATE TABLE things (number INTEGER, name TEXT, bytes BLOB NOT NULL)");
    Statement insert(database, "INSERT INTO things VALUES (?, ?, ?)");
    for (const std::string& bytes : {std::string("\0\xff", 2), std::string()}) {
      insert.bind(1, -7'000'000'000);
      insert.bindText(2, "na'me");
      insert.bindBytes(3, bytes.empty() ? std::string_view() : std::string_view(bytes));
      EXPECT_FALSE(insert.step());
      insert.reset();
    }
  }
  const Database database(path_.string(), path_, Database::Access::kRead);
  Statement select(database, "SELECT number, name, bytes FROM things ORDER BY length(bytes) DESC");
  ASSERT_TRUE(select.step());
  EXPECT_EQ(select.number(0), -7'000'000'000);
  EXPECT_EQ(select.text(1), "na'me");
  EXPECT_EQ(select.text(2), std::string_view("\0\xff", 2));
  ASSERT_TRUE(select.step());
  EXPECT_EQ(select.text(2), "");
  EXPECT_FALSE(select.step());
}

TEST_F(DatabaseTest, SaysWhatCannotBeDone) {
  const std::string name = "'" + path_.string() + "'";
  EXPECT_NE(refusal([&] { Database(path_.string(), path_, Database::Access::kRead); }).find(name + " can't be opened"),
            std::string::npos);
  folder_.write("a.tlog", std::string(5000, 'x'));
  const Database text(path_.string(), path_, Database::Access::kRead);
  EXPECT_EQ(
      refusal([&] { Statement(text, "SELECT 1 FROM topics"); }),
      name +
          " can't be read: file is not a database (a tlog file is an SQLite database, such as Fortress's state.tlog)");
  const std::filesystem::path other = folder_.path() / "b.tlog";
  const Database written(other.string(), other, Database::Access::kCreate);
  EXPECT_NE(refusal([&] { written.run("INSERT INTO absent VALUES (1)"); }).find("can't be written: no such table"),
            std::string::npos);
}

}  // namespace
}  // namespace pongsim::log
