#include "log/command/new_log.hh"

#include <gtest/gtest.h>

#include "log/command/log_file.hh"
#include "log/store/failure.hh"
#include "shared/program/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

class NewLogTest : public testing::Test {
 protected:
  std::unique_ptr<Writer> newLogAt(const std::filesystem::path& file, bool overwrites = false) {
    return newLog(file, {.overwrites = overwrites},
                  [](std::string_view, std::string_view type) { return protobufDefinition(type); });
  }
  /// @return The message and its hint.
  std::string refusal(const std::filesystem::path& file) {
    try {
      newLogAt(file);
    } catch (const Failure& failure) {
      return std::string(failure.what()) + " (" + failure.hint() + ")";
    }
    return "it is taken";
  }

  test::TempFolder folder_;
};

TEST_F(NewLogTest, HasTheFormatThatItsNameSays) {
  for (const auto& [name, format] : {std::pair("a.mcap", Format::kMcap), std::pair("a.tlog", Format::kTlog)}) {
    const std::filesystem::path file = folder_.path() / name;
    const auto writer = newLogAt(file);
    writer->write({5, "/a", "ignition.msgs.Empty", ""});
    writer->close();
    const LogFile log(file);
    EXPECT_EQ(log.format(), format);
    EXPECT_EQ(log.reader().topics(), (std::vector<Topic>{{"/a", "ignition.msgs.Empty", 1}}));
  }
  EXPECT_THROW(newLogAt(folder_.path() / "a.bag"), cli::UsageError);
}

TEST_F(NewLogTest, LeavesWhatIsThere) {
  for (const char* name : {"a.mcap", "a.tlog"}) {
    const std::filesystem::path file = folder_.write(name, "old");
    EXPECT_EQ(refusal(file), "'" + file.string() + "' already exists (use --force to overwrite it)");
    EXPECT_EQ(std::filesystem::file_size(file), 3U);
    newLogAt(file, true)->close();
    EXPECT_GT(std::filesystem::file_size(file), 3U);
  }
  // a dangling link counts as an existing file, too
  std::filesystem::create_symlink("nothing", folder_.path() / "link.mcap");
  EXPECT_NE(refusal(folder_.path() / "link.mcap").find("already exists"), std::string::npos);
  std::filesystem::create_directory(folder_.path() / "folder.mcap");
  EXPECT_THROW(newLogAt(folder_.path() / "folder.mcap", true), Failure);
}

TEST_F(NewLogTest, OfRosIsMcap) {
  EXPECT_NO_THROW(checkRos2Name("a.mcap"));
  EXPECT_THROW(checkRos2Name("a.tlog"), cli::UsageError);
  EXPECT_THROW(checkRos2Name("a"), cli::UsageError);
}

}  // namespace
}  // namespace pongsim::log
