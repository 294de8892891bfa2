// Installs pongsim into a folder, and builds and runs third-party code with it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/process.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

/// Namespaces of hidden symbols.
constexpr std::string_view kLayers[] = {"base",  "description", "assets",    "urdf",    "sdf",
                                        "world", "sensing",     "rendering", "physics", "msgs",
                                        "trust", "transport",   "plugin",    "sim",     "cli"};

class PackageTest : public testing::Test {
 protected:
  void SetUp() override {
    testDomain();
    run("'" PONGSIM_CMAKE "' --install '" PONGSIM_BUILD_FOLDER "' --prefix installed >/dev/null");
    // move the installation, because nothing may depend on its original path
    std::filesystem::rename(folder_.path() / "installed", folder_.path() / "moved");
  }

  /// Runs a script in the test's folder, with the installed program found first.
  /// @return Its output.
  std::string run(const std::string& script) {
    const std::string path = (folder_.path() / "moved" / "bin").string();
    Process shell({"bash", "-euc", "export PATH=" + path + ":$PATH\n" + script},
                  {.environment = {}, .folder = folder_.path()});
    const std::optional<int> code = shell.wait(std::chrono::minutes(5));
    EXPECT_EQ(code, 0) << script << "\n" << shell.output() << shell.error();
    return shell.output();
  }

  void build(const std::string& source, const std::string& to) {
    run("'" PONGSIM_CMAKE "' -G '" PONGSIM_GENERATOR "' -S '" + source + "' -B " + to +
        " -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH=\"$PWD/moved\" -DCMAKE_CXX_FLAGS='" PONGSIM_FOREIGN_FLAGS
        "' && '" PONGSIM_CMAKE "' --build " +
        to + " --parallel 2");
  }

  static std::string example(const std::string& name) { return (projectFolder() / "examples" / name).string(); }

  TempFolder folder_;
};

TEST_F(PackageTest, RunsWorldsWithItsOwnSystems) {
  const std::string world = (projectFolder() / "plugins/drives/diff-drive/diff_drive.sdf").string();
  run("pongsim run '" + world + "' -z 0 --iterations 10 --strict -v 1");
  EXPECT_NE(run("pongsim plugin -l")
                .find("diff-drive\tignition::gazebo::systems::DiffDrive\t" + (folder_.path() / "moved").string()),
            std::string::npos);
}

TEST_F(PackageTest, HasTheProgramThatDownloads) {
  EXPECT_EQ(run("IGN_FUEL_CACHE_PATH=$PWD/cache pongsim fuel check"), "0 models, 0 worlds: all complete\n");
  // the loader runs this program too, which says that it does not know the server
  const std::string said = run(
      "echo '<sdf version=\"1.9\"><world name=\"w\"><include><uri>https://example.invalid/o/models/m</uri></include>"
      "</world></sdf>' >w.sdf\n"
      "env -u PONGSIM_OFFLINE IGN_FUEL_CACHE_PATH=$PWD/cache HOME=$PWD pongsim run w.sdf 2>&1 && exit 1 || true");
  EXPECT_NE(said.find("the server example.invalid is not configured"), std::string::npos) << said;
}

TEST_F(PackageTest, BuildsASystemOfOnesOwn) {
  build(example("custom_system"), "custom");
  run("ctest --test-dir custom --output-on-failure");
  const std::string told = run("pongsim plugin -i custom/libdistance-meter.so");
  EXPECT_NE(told.find("class example::DistanceMeter\n"), std::string::npos) << told;
  EXPECT_NE(told.find("<rate>   number [Hz]  10"), std::string::npos) << told;
  // once installed, it is found without further settings
  run("'" PONGSIM_CMAKE "' --install custom --prefix moved >/dev/null");
  run("pongsim run '" + example("custom_system") + "/distance_meter.sdf' -z 0 --iterations 10 --strict -v 1");
}

TEST_F(PackageTest, BuildsAProgramThatAvoidsWalls) {
  build(example("wall_avoider"), "avoider");
  const std::string script =
      "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\n"
      "avoider/wall_avoider &\n"
      "answer() {\n"
      "  pongsim topic -e -t /cmd_vel -n 1 --field linear.x --field angular.z > answer &\n"
      "  echo=$!\n"
      "  while kill -0 $echo 2>/dev/null; do\n"
      "    pongsim topic -t /lidar -m LaserScan -p \"$1\" --timeout 60\n"
      "  done\n"
      "  cat answer\n"
      "}\n";
  EXPECT_EQ(run(script + "answer 'ranges: [2, 3, inf]'"), "0.5\t0\n");
  EXPECT_EQ(run(script + "answer 'ranges: [2, 0.9, inf]'"), "0\t0.5\n");
}

TEST_F(PackageTest, TestsARobotWithScenariosAndGoogleTest) {
  const bool isSanitized = std::string_view(PONGSIM_FOREIGN_FLAGS) != "";
  if (isSanitized || !std::filesystem::exists(folder_.path() / "moved/libexec/pongsim/pongsim-test")) {
    GTEST_SKIP() << "pongsim test is not in this build, or does not start with sanitizers";
  }
  build(example("testing"), "robot");
  const std::string told = run("ctest --test-dir robot --output-on-failure --verbose");
  EXPECT_NE(told.find("8 passed; "), std::string::npos) << told;
  EXPECT_NE(told.find("100% tests passed, 0 tests failed out of 2"), std::string::npos) << told;
  // ctest shows what a scenario says that fails
  run("mkdir bad && cat >bad/CMakeLists.txt <<'END'\n"
      "cmake_minimum_required(VERSION 3.20)\nproject(bad LANGUAGES CXX)\nenable_testing()\nfind_package(pongsim "
      "REQUIRED)\n"
      "pongsim_add_scenario_test(fly fly.yaml OPTIONS --quiet)\nEND\n"
      "cat >bad/fly.yaml <<'END'\n"
      "world: pong_world.sdf\nduration: 1\nexpect:\n  - {pose: pong_bot, eventually: {z: {above: 1}}}\nEND\n"
      "'" PONGSIM_CMAKE
      "' -S bad -B bad/build -DCMAKE_PREFIX_PATH=\"$PWD/moved\" >/dev/null\n"
      "! ctest --test-dir bad/build --output-on-failure >said 2>&1\n"
      "grep -q 'expected  eventually pose of pong_bot: z > 1' said\n"
      "test -f bad/build/test-failures/fly/fly.seed=0/log.txt");
}

TEST_F(PackageTest, BuildsTheSystemThatItBeginsForOne) {
  const std::string told = run("pongsim plugin new my-own-system");
  EXPECT_NE(told.find("cd my-own-system && cmake"), std::string::npos) << told;
  build("my-own-system", "own");
  run("ctest --test-dir own --output-on-failure");
  const std::string info = run("PONGSIM_PLUGIN_PATH=own pongsim plugin -i my-own-system");
  EXPECT_NE(info.find("class MyOwnSystem\nLifts a model.\nBelongs in a <model>.\n"), std::string::npos) << info;
  EXPECT_NE(info.find("subscribes to  <topic>  ignition.msgs.Double  force [N]"), std::string::npos) << info;
}

/// @return The exported symbols of a library.
std::vector<std::string> exportsOf(const std::filesystem::path& library) {
  Process nm({"nm", "-D", "--defined-only", "--format=posix", library.string()});
  EXPECT_EQ(nm.wait(), 0) << nm.error();
  std::vector<std::string> names;
  std::istringstream lines(nm.output());
  for (std::string line; std::getline(lines, line);) names.push_back(line.substr(0, line.find(' ')));
  return names;
}

TEST_F(PackageTest, OffersWhatItsHeadersDeclareAndNothingElse) {
  const auto libraries = folder_.path() / "moved" / PONGSIM_LIBRARY_FOLDER;
  std::string declared;
  for (const auto& header : std::filesystem::recursive_directory_iterator(folder_.path() / "moved/include/pongsim")) {
    if (header.path().extension() != ".hh") continue;
    std::ifstream stream(header.path());
    declared.append(std::istreambuf_iterator<char>(stream), {});
  }
  // _ZN7pongsim10SimulationC1Ev, _ZTIN7pongsim4GoneE: a name after its length
  const Regex ownName("N[KRO]*7pongsim(\\d+)(\\w+)");
  const std::vector<std::string> names = exportsOf(libraries / "libpongsim.so");
  for (const std::string& name : names) {
    // the program's own entry points
    if (name == "pongsim_main" || name.starts_with("pongsim_write_")) continue;
    const Regex::Match found = ownName.firstIn(name);
    ASSERT_FALSE(found.empty()) << name;
    const std::string member = found[2].substr(0, std::stoul(found[1]));
    EXPECT_EQ(std::ranges::count(kLayers, member), 0) << name;
    EXPECT_NE(declared.find(member), std::string::npos) << name;
  }
  EXPECT_GT(names.size(), 100U);

  int systems = 0;
  for (const auto& library : std::filesystem::directory_iterator(libraries / "pongsim/plugins")) {
    // beside them are modules in Python
    if (library.path().extension() != ".so") continue;
    std::vector<std::string> offered = exportsOf(library.path());
    // a library that also exports a message encoder
    if (library.path().filename() == "libpongsim-ros2-system.so") {
      EXPECT_EQ(std::erase(offered, "pongsim_encoder"), 1);
    }
    EXPECT_EQ(offered, std::vector<std::string>{"pongsim_systems"}) << library.path();
    ++systems;
  }
  EXPECT_GT(systems, 20);
}

/// @return The folders in which programs and libraries below some folders have their libraries looked for.
std::vector<std::string> librarySearchPaths(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> command{"readelf", "--dynamic", "--wide"};
  for (const auto& folder : folders) {
    // a build may be without Python
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.is_symlink() || !entry.is_regular_file()) continue;
      std::string start(4, ' ');
      std::ifstream(entry.path()).read(start.data(), 4);
      if (start == "\177ELF") command.push_back(entry.path().string());
    }
  }
  Process readelf(command);
  EXPECT_EQ(readelf.wait(), 0) << readelf.error();
  std::vector<std::string> paths;
  const Regex path("\\((RPATH|RUNPATH)\\).*\\[(.*)\\]");
  std::istringstream lines(readelf.output());
  for (std::string line; std::getline(lines, line);) {
    const Regex::Match found = path.firstIn(line);
    if (found.empty()) continue;
    // with the entry behind a colon at the end, which is the current folder
    std::istringstream entries(found[2] + ":end");
    for (std::string entry; std::getline(entries, entry, ':');) paths.push_back(entry);
    paths.pop_back();
  }
  return paths;
}

TEST_F(PackageTest, LooksForLibrariesInFoldersRelativeToItsOwnOnly) {
  const std::filesystem::path build(PONGSIM_BUILD_FOLDER);
  const std::vector<std::string> paths = librarySearchPaths(
      {folder_.path() / "moved", build / "bin", build / PONGSIM_LIBRARY_FOLDER, build / "libexec", build / "python"});
  // each system's library, installed and in the build tree
  EXPECT_GT(paths.size(), 100U);
  for (const std::string& path : paths) EXPECT_TRUE(path.starts_with("$ORIGIN")) << "'" << path << "'";
}

TEST_F(PackageTest, HasManualAndCompletionOfItsOwn) {
  const auto share = folder_.path() / "moved/share";
  for (const char* file : {"man/man1/pongsim.1", "man/man1/pongsim-run.1", "bash-completion/completions/pongsim",
                           "zsh/site-functions/_pongsim", "pongsim/worlds/pong_world.sdf"}) {
    EXPECT_GT(std::filesystem::file_size(share / file), 100U) << file;
  }
}

}  // namespace
}  // namespace pongsim::test
