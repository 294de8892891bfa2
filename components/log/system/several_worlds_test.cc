// Several worlds of a file, recorded with command-line options and played.

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "log/playback/played_files.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_reader.hh"
#include "support/log/log_support.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

class SeveralRecordedWorlds : public testing::Test {
 protected:
  fs::path recording() const { return folder_.path() / "rec"; }

  /// Makes 10 steps of world "w" and 20 of "v", as `pongsim run --record-path REC` does.
  void record(const std::vector<std::string>& more = {}) {
    const auto world = [](const std::string& name) {
      return "<world name='" + name + "'>" + test::pendulum("p_" + name, "0 0 2 0 0 0") + "</world>";
    };
    const fs::path file = folder_.write("two.sdf", "<sdf version='1.9'>" + world("w") + world("v") + "</sdf>");
    Element plugin;
    plugin.name = "plugin";
    plugin.attributes = {{"filename", "pongsim-log-system", {}}, {"name", "ignition::gazebo::systems::LogRecord", {}}};
    const auto set = [&plugin](const std::string& name, const std::string& text) {
      plugin.children.emplace_back();
      plugin.children.back().name = name;
      plugin.children.back().text = text;
    };
    set("record_path", recording().string());
    for (const std::string& name : more) set(name, "true");
    Diagnostics diagnostics;
    const auto worlds = Simulation::allFromFile(file, {.systems = {plugin}}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_EQ(worlds.size(), 2U);
    worlds[0]->step(10);
    worlds[1]->step(20);
  }

  static std::size_t states(const fs::path& folder, const std::string& world) {
    for (const Topic& each : TlogReader(folder / "state.tlog").topics()) {
      if (each.name == "/world/" + world + "/changed_state") return each.count;
    }
    return 0;
  }

  test::TempFolder folder_;
};

TEST_F(SeveralRecordedWorlds, HaveAFolderEachInTheOneThatWasNamed) {
  record();
  EXPECT_EQ(states(recording() / "w", "w"), 10U);
  EXPECT_EQ(states(recording() / "v", "v"), 20U);
  EXPECT_FALSE(fs::exists(recording() / "state.tlog"));
  record({"keep_existing"});
  EXPECT_EQ(states(folder_.path() / "rec(1)/w", "w"), 10U);
  EXPECT_EQ(states(folder_.path() / "rec(1)/v", "v"), 20U);
  record({"overwrite"});
  EXPECT_EQ(states(recording() / "v", "v"), 20U);
  EXPECT_FALSE(fs::exists(folder_.path() / "rec(2)"));
}

TEST_F(SeveralRecordedWorlds, ArePackedTogether) {
  record({"compress"});
  EXPECT_FALSE(fs::exists(recording()));
  const fs::path zip = folder_.path() / "rec.zip";
  ASSERT_TRUE(fs::is_regular_file(zip));
  try {
    const PlayedFiles files(zip);
    FAIL();
  } catch (const Failure& why) {
    EXPECT_EQ(std::string(why.what()), "there are several recordings in '" + zip.string() + "': v, w");
    EXPECT_EQ(std::string(why.hint()), "play one at a time: unpack it and give the folder of one");
  }
}

TEST_F(SeveralRecordedWorlds, ArePlayedOneAtATime) {
  record();
  test::testDomain();
  const auto run = [](const fs::path& path) {
    auto process = std::make_unique<test::Process>(
        std::vector<std::string>{PONGSIM_PROGRAM, "run", "--playback", path.string(), "-z", "0", "--iterations", "5"});
    EXPECT_TRUE(process->wait().has_value());
    return process;
  };
  const auto one = run(recording() / "v");
  EXPECT_EQ(one->wait(), 0) << one->error();
  EXPECT_NE(one->error().find("world 'v': 1 model"), std::string::npos) << one->error();
  const auto all = run(recording());
  EXPECT_EQ(all->wait(), 1);
  EXPECT_NE(all->error().find("there are several recordings in '" + recording().string() + "': v, w"),
            std::string::npos)
      << all->error();
  EXPECT_NE(all->error().find("'" + (recording() / "v").string() + "', for example"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::log
