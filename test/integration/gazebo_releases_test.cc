// Tests each cell of the table of releases in docs/gazebo.md.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

constexpr std::array kReleases = {"Fortress", "Garden", "Harmonic", "Ionic", "Jetty"};

/// The cells of a row, one for each release, without the marks of code.
using Row = std::array<std::string, kReleases.size()>;

std::string plain(std::string cell) {
  std::erase(cell, '`');
  const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
  return first == std::string::npos ? "" : cell.substr(first, last - first + 1);
}

/// @return The rows of the page's first table, by what stands in front of them.
std::map<std::string, Row> readTable() {
  std::ifstream page(projectFolder() / "docs/gazebo.md");
  std::map<std::string, Row> rows;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with('|')) {
      if (!rows.empty()) break;
      continue;
    }
    std::istringstream cells(line.substr(1));
    std::string name, cell;
    std::getline(cells, name, '|');
    Row row;
    for (std::string& each : row) {
      std::getline(cells, cell, '|');
      each = plain(cell);
    }
    rows[plain(name)] = row;
  }
  return rows;
}

class GazeboReleases : public testing::Test {
 protected:
  GazeboReleases() {
    testDomain();
    for (const char* name : {"ign", "gz"}) std::filesystem::create_symlink(PONGSIM_PROGRAM, folder_.path() / name);
  }

  /// @param command "ign gazebo".
  Outcome run(const std::string& command, std::vector<std::string> arguments,
              const std::map<std::string, std::string>& environment = {}) {
    const std::size_t space = command.find(' ');
    arguments.insert(arguments.begin(),
                     {(folder_.path() / command.substr(0, space)).string(), command.substr(space + 1)});
    Process process(arguments, {.environment = environment, .folder = folder_.path()});
    return {process.wait().value_or(-1), process.output(), process.error()};
  }
  /// @return The value of a row for the i-th release.
  std::string at(const std::string& row, std::size_t i) { return table_.at(row)[i]; }

  TempFolder folder_;
  std::map<std::string, Row> table_ = readTable();
};

TEST_F(GazeboReleases, AreThoseOfThePage) {
  ASSERT_EQ(table_.size(), 10U) << "a row without a test, or none where a test expects it";
  for (std::size_t i = 0; i < kReleases.size(); ++i) EXPECT_EQ(at("", i), kReleases[i]);
}

TEST_F(GazeboReleases, RunTheirFilesByTheirCommandAndVersion) {
  for (std::size_t i = 0; i < kReleases.size(); ++i) {
    const std::string command = at("command", i), version = at("--force-version that is accepted", i);
    folder_.write("worlds/mine.sdf", "<sdf version='" + at("newest version of SDF", i) +
                                         "'><world name='w'><plugin filename='" + at("file of a system", i) +
                                         "' name='" + at("its class", i) + "'/></world></sdf>");
    const std::map<std::string, std::string> where{
        {at("folders of worlds and models", i), (folder_.path() / "worlds").string()}};
    const Outcome ran = run(command, {"-s", "-r", "--iterations", "2", "--force-version", version, "mine.sdf"}, where);
    EXPECT_EQ(ran.exitCode, 0) << kReleases[i] << ran.error;
    EXPECT_EQ(ran.error.find("was not found"), std::string::npos) << kReleases[i] << ran.error;
    EXPECT_NE(("\n" + run(command, {"--versions"}).output).find("\n" + version + "\n"), std::string::npos);
    const Outcome checked = run(command.substr(0, command.find(' ')) + " sdf", {"-k", "worlds/mine.sdf"});
    EXPECT_EQ(checked.output, "Valid.\n") << kReleases[i] << checked.error;
    EXPECT_EQ(checked.error, "") << kReleases[i];
  }
}

TEST_F(GazeboReleases, HaveTheirNamesOfMessages) {
  for (std::size_t i = 0; i < kReleases.size(); ++i) {
    const std::string command = at("command", i), type = at("message type", i);
    const Outcome info = run(command.substr(0, command.find(' ')) + " msg", {"-i", type});
    EXPECT_TRUE(info.output.starts_with("Name: " + type + "\n")) << kReleases[i] << info.output << info.error;
  }
}

TEST_F(GazeboReleases, HaveAnOptionForTheirClients) {
  const std::string help = runToEnd({"run", "--help"}).output;
  for (std::size_t i = 0; i < kReleases.size(); ++i) {
    EXPECT_NE(help.find("  " + at("option for its clients", i) + " "), std::string::npos) << kReleases[i];
  }
}

}  // namespace
}  // namespace pongsim::test
