// Every world of the project runs as it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/regex.hh"
#include "support/working_folder.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> worldsBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".sdf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Worlds, OfTheProjectRunWithoutAWarning) {
  // some write into the current folder
  const WorkingFolder folder;
  std::vector<fs::path> files = worldsBelow(projectFolder() / "worlds");
  const std::vector<fs::path> ofSystems = worldsBelow(projectFolder() / "plugins");
  files.insert(files.end(), ofSystems.begin(), ofSystems.end());
  EXPECT_GE(files.size(), 4U);
  for (const fs::path& file : files) {
    const Outcome outcome = runToEnd({"run", file.string(), "-z", "0", "--iterations", "1000"});
    EXPECT_EQ(outcome.exitCode, 0) << file;
    for (const std::string& line : lines(outcome.error)) EXPECT_TRUE(line.starts_with("pongsim: world '")) << line;
  }
}

// Unsupported features are reported with their positions, without other effects.
TEST(Worlds, OfFortressRunOrSayWhyNot) {
  const auto folder = fortressWorlds();
  if (!folder) GTEST_SKIP() << "no worlds of Fortress here";
  const Regex complaint("([^:]+:\\d+:\\d+: (warning|error): .*|  .*|pongsim: .*|warning: .*)");
  for (const char* part : {"tutorials", "examples"}) {
    for (const fs::path& file : worldsBelow(*folder / part)) {
      const Outcome outcome = runToEnd({"run", file.string(), "-z", "0", "--iterations", "20"});
      const bool hasErrors = outcome.error.find(": error: ") != std::string::npos;
      EXPECT_EQ(outcome.exitCode, hasErrors ? 1 : 0) << file << "\n" << outcome.error;
      for (const std::string& line : lines(outcome.error)) EXPECT_TRUE(complaint.matches(line)) << line;
    }
  }
}

}  // namespace
}  // namespace pongsim::test
