// Every world of pongsim and of Fortress that runs here ends with the same bits in its state and its systems' messages,
// whatever the environment of the process. All topics that it subscribes to get messages.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasSanitizer = true;
#else
constexpr bool kHasSanitizer = false;
#endif

/// Differences between two machines, or between two runs on one.
struct Surroundings {
  const char* what;
  std::map<std::string, std::string> environment;
  std::string threads = "1";
};

const Surroundings kSurroundings[] = {
    {"a C library without fused multiply-add and AVX2", {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"}}},
    {"a C library for the oldest processor",
     {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,-SSE4_2,-SSE4_1,-SSSE3"}}},
    {"another C library's elementary functions", {{"LD_PRELOAD", OTHER_LIBM}}},
    {"two threads", {}, "2"},
    {"four threads, freed memory overwritten", {{"MALLOC_PERTURB_", "90"}}, "4"},
};

std::vector<std::string> worldsIn(const fs::path& folder) {
  std::vector<std::string> worlds;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".sdf") worlds.push_back(entry.path().string());
  }
  std::ranges::sort(worlds);
  return worlds;
}

class Determinism : public testing::Test {
 protected:
  /// @return The output for each world, one per line.
  std::vector<std::string> hashes(const std::vector<std::string>& worlds, const Surroundings& around) {
    std::vector<std::string> command = {WORLD_HASHES, around.threads, "1000"};
    command.insert(command.end(), worlds.begin(), worlds.end());
    std::map<std::string, std::string> environment = around.environment;
    environment["HOME"] = home_.path();
    environment["PONGSIM_OFFLINE"] = "1";
    if (const auto folder = fortressWorlds()) environment["IGN_GAZEBO_RESOURCE_PATH"] = *folder / "test/models";
    Process process(command, {.environment = environment, .folder = home_.path()});
    EXPECT_EQ(process.wait(5 * kDeadline), 0) << around.what << ": " << process.error();
    std::vector<std::string> lines;
    std::istringstream output(process.output());
    for (std::string line; std::getline(output, line);) lines.push_back(line);
    return lines;
  }

  void expectTheSame(const std::vector<std::string>& worlds) {
    const std::vector<std::string> expected = hashes(worlds, {"nothing else", {}});
    EXPECT_GE(expected.size(), worlds.size() / 2);
    EXPECT_GE(expected.size(), 40U);
    for (const Surroundings& around : kSurroundings) {
      // the sanitizer itself must be preloaded first
      if (kHasSanitizer && around.environment.contains("LD_PRELOAD")) continue;
      const std::vector<std::string> found = hashes(worlds, around);
      ASSERT_EQ(found.size(), expected.size()) << around.what;
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected[i]) << around.what;
    }
  }

 private:
  TempFolder home_;
};

TEST_F(Determinism, HoldsForOurWorldsAndThoseOfEachSystem) {
  std::vector<std::string> worlds = worldsIn(projectFolder() / "worlds");
  const std::vector<std::string> ofSystems = worldsIn(projectFolder() / "plugins");
  worlds.insert(worlds.end(), ofSystems.begin(), ofSystems.end());
  expectTheSame(worlds);
}

TEST_F(Determinism, HoldsForTheWorldsOfFortress) {
  const auto folder = fortressWorlds();
  if (!folder) GTEST_SKIP() << "no worlds of Fortress here";
  std::vector<std::string> worlds = worldsIn(*folder / "examples");
  for (const char* part : {"test", "tutorials"}) {
    const std::vector<std::string> more = worldsIn(*folder / part);
    worlds.insert(worlds.end(), more.begin(), more.end());
  }
  expectTheSame(worlds);
}

}  // namespace
}  // namespace pongsim::test
