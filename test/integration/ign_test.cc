// Tests the program under the name `ign`, as scripts for Fortress use it.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "integration/program.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

class Ign : public testing::Test {
 protected:
  Ign() {
    testDomain();
    std::filesystem::create_symlink(PONGSIM_PROGRAM, ign_);
    std::filesystem::create_symlink(PONGSIM_PROGRAM, gz_);
  }

  Outcome ign(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment = {}) {
    return named(ign_, std::move(arguments), environment);
  }
  Outcome gz(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment = {}) {
    return named(gz_, std::move(arguments), environment);
  }

  TempFolder folder_;

 private:
  Outcome named(const std::string& program, std::vector<std::string> arguments,
                const std::map<std::string, std::string>& environment) {
    arguments.insert(arguments.begin(), program);
    Process process(arguments, {.environment = environment, .folder = folder_.path()});
    return {process.wait().value_or(-1), process.output(), process.error()};
  }

  std::string ign_ = (folder_.path() / "ign").string(), gz_ = (folder_.path() / "gz").string();
};

TEST_F(Ign, TakesTheOptionsOfAHeadlessServer) {
  const Outcome run = ign({"gazebo", "-srv4", ownWorld("pong_world.sdf"), "--iterations", "5", "-z", "0",
                           "--headless-rendering", "--render-engine", "ogre2", "--render-engine-server", "ogre2",
                           "--render-engine-gui", "ogre", "--gui-config", "none.config", "--force-version", "6"});
  EXPECT_EQ(run.exitCode, 0) << run.error;
  EXPECT_EQ(run.error.find("has no effect"), std::string::npos) << run.error;
}

TEST_F(Ign, SaysWhatChangesNothing) {
  const Outcome run = ign({"gazebo", "-r", ownWorld("pong_world.sdf"), "--iterations", "1", "--physics-engine",
                           "ignition-physics-tpe-plugin", "--gui-config", "x", "-v", "2"},
                          {{"IGN_IP", "192.168.7.7"}});
  EXPECT_EQ(run.exitCode, 0) << run.error;
  for (const char* word : {"'--physics-engine'", "'--gui-config'", "IGN_IP"}) {
    EXPECT_NE(run.error.find("pongsim: warning: " + std::string(word) + " has no effect"), std::string::npos)
        << run.error;
  }
  EXPECT_EQ(ign({"gazebo", "-r", ownWorld("pong_world.sdf"), "--iterations", "1", "--gui-config", "x", "-v", "1"})
                .error.find("has no effect"),
            std::string::npos);
}

TEST_F(Ign, RefusesWhatCannotBeWithASentence) {
  const std::vector<std::vector<std::string>> lines = {{"gazebo", "-g", "a.sdf"},
                                                       {"gazebo", "--network-role", "primary", "a.sdf"},
                                                       {"gazebo", "--force-version", "7", "a.sdf"},
                                                       {"gazebo", "--render-engine", "optix", "a.sdf"},
                                                       {"gui", "-l"},
                                                       {"launch", "a.ign"}};
  for (const std::vector<std::string>& line : lines) {
    const Outcome refused = ign(line);
    EXPECT_EQ(refused.exitCode, 2) << line.back();
    EXPECT_NE(refused.error.find("\n  hint: "), std::string::npos) << refused.error;
    EXPECT_EQ(refused.error.find("unknown"), std::string::npos) << refused.error;
  }
}

TEST_F(Ign, TellsOfVersions) {
  EXPECT_EQ(ign({"gazebo", "--versions"}).output, "6\n");
  EXPECT_TRUE(ign({"topic", "-v"}).output.starts_with("pongsim ")) << ign({"topic", "-v"}).output;
  EXPECT_TRUE(ign({"service", "--version"}).output.starts_with("pongsim "));
}

TEST_F(Ign, NamesMessageTypesAsThere) {
  const Outcome list = ign({"msg", "-l"});
  EXPECT_NE(list.output.find("\nign_msgs.Twist\n"), std::string::npos) << list.output;
  const Outcome info = ign({"msg", "-i", "ign_msgs.Twist"});
  EXPECT_TRUE(info.output.starts_with("Name: ignition.msgs.Twist\nFile: ignition/msgs/twist.proto\n\n")) << info.output;
}

TEST_F(Ign, TakesThePathOfAPluginByItself) {
  const Outcome named = ign({"plugin", "--info", "--plugin", "diff-drive"});
  EXPECT_EQ(named.exitCode, 0) << named.error;
  EXPECT_EQ(named.output, runToEnd({"plugin", "-i", "diff-drive"}).output);
  EXPECT_EQ(ign({"plugin", "-i", "-v", "-p", "diff-drive"}).output, named.output);
}

TEST_F(Ign, SaysWhichWorldItAsksForModels) {
  const std::unique_ptr<Process> world = startServedWorld("pong_world.sdf", {"--paused"});
  const Outcome list = ign({"model", "--list", "--timeout", "60000"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  EXPECT_EQ(list.output,
            "\nRequesting state for world [pong_world]...\n\nAvailable models:\n    - ground_plane\n    - court\n"
            "    - pong_bot\n");
}

using Gz = Ign;

TEST_F(Gz, TakesTheOptionsOfAHeadlessServer) {
  const Outcome run = gz({"sim",
                          "-s",
                          "-r",
                          "-v4",
                          ownWorld("pong_world.sdf"),
                          "--iterations",
                          "5",
                          "-z",
                          "0",
                          "--seed",
                          "7",
                          "--headless-rendering",
                          "--render-engine",
                          "ogre2",
                          "--render-engine-server-api-backend",
                          "vulkan",
                          "--wait-for-assets",
                          "--initial-sim-time",
                          "0",
                          "--gui-config",
                          "none.config",
                          "--force-version",
                          "8"});
  EXPECT_EQ(run.exitCode, 0) << run.error;
  EXPECT_EQ(run.error.find("has no effect"), std::string::npos) << run.error;
}

TEST_F(Gz, RefusesWhatCannotBeWithASentence) {
  const std::vector<std::vector<std::string>> lines = {{"sim", "-g", "a.sdf"},
                                                       {"sim", "--initial-sim-time", "10", "a.sdf"},
                                                       {"sim", "--force-version", "6", "a.sdf"},
                                                       {"sim", "--render-engine-api-backend", "glide", "a.sdf"},
                                                       {"param", "-l"},
                                                       {"gui"}};
  for (const std::vector<std::string>& line : lines) {
    const Outcome refused = gz(line);
    EXPECT_EQ(refused.exitCode, 2) << line.back();
    EXPECT_NE(refused.error.find("\n  hint: "), std::string::npos) << refused.error;
    EXPECT_EQ(refused.error.find("unknown"), std::string::npos) << refused.error;
  }
}

TEST_F(Gz, NamesTheNearestToWhatIsMisspelt) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> lines = {
      {{"sim", "-s", "--iteratons", "5", "a.sdf"},
       "unknown option '--iteratons'\n  hint: did you mean '--iterations'?"},
      {{"topic", "--frequenci", "-t", "/a"}, "unknown option '--frequenci'\n  hint: did you mean '--frequency'?"},
      {{"sdf", "--prin", "a.sdf"}, "did you mean '--print'?"},
      {{"servise", "-l"}, "unknown command 'servise'\n  hint: did you mean 'service'?"}};
  for (const auto& [line, words] : lines) {
    const Outcome refused = gz(line);
    EXPECT_EQ(refused.exitCode, 2) << line.front();
    EXPECT_NE(refused.error.find(words), std::string::npos) << refused.error;
  }
}

TEST_F(Gz, TellsOfVersionsByTheNameUsed) {
  EXPECT_EQ(gz({"sim", "--versions"}).output, "10\n9\n8\n7\n");
  EXPECT_EQ(ign({"gazebo", "--versions"}).output, "6\n");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--versions"}, {"topic", "--versions"}}) {
    EXPECT_TRUE(runToEnd({"--version"}).output.starts_with("pongsim " + runToEnd(words).output)) << words.front();
  }
}

TEST_F(Gz, NamesMessageTypesAsThere) {
  EXPECT_NE(gz({"msg", "-l"}).output.find("\ngz.msgs.Twist\n"), std::string::npos);
  const Outcome info = gz({"msg", "-i", "gz.msgs.Twist"});
  EXPECT_TRUE(info.output.starts_with("Name: gz.msgs.Twist\nFile: gz/msgs/twist.proto\n\n")) << info.output;
  EXPECT_EQ(info.output.find("ignition"), std::string::npos) << info.output;
}

TEST_F(Gz, TalksToAWorldWithTheNamesOfThere) {
  const std::unique_ptr<Process> world = startServedWorld("pong_world.sdf", {"--paused"});
  const Outcome topic = gz({"topic", "-i", "-t", "/clock"});
  EXPECT_NE(topic.output.find(", gz.msgs.Clock, "), std::string::npos) << topic.output << topic.error;
  const Outcome service = gz({"service", "-i", "-s", "/world/pong_world/control"});
  EXPECT_NE(service.output.find(", gz.msgs.WorldControl, gz.msgs.Boolean\n"), std::string::npos)
      << service.output << service.error;
  const Outcome called = gz({"service", "-s", "/world/pong_world/control", "--reqtype", "gz.msgs.WorldControl",
                             "--reptype", "gz.msgs.Boolean", "--timeout", "60000", "--req", "pause: true"});
  EXPECT_EQ(called.output, "data: true\n\n") << called.error;
  // without a request, whose type has nothing in it
  const Outcome worlds = gz({"service", "-s", "/gazebo/worlds", "--timeout", "60000", "-r"});
  EXPECT_EQ(worlds.output, "data: \"pong_world\"\n\n") << worlds.error;
}

TEST_F(Gz, FindsFilesAndWorldsByTheLaterVariables) {
  TempFolder worlds;
  std::filesystem::copy_file(ownWorld("pong_world.sdf"), worlds.path() / "mine.sdf");
  EXPECT_EQ(gz({"sim", "-s", "-r", "mine.sdf", "--iterations", "1"}, {{"GZ_SIM_RESOURCE_PATH", worlds.path().string()}})
                .exitCode,
            0);
  const Outcome warned = gz({"sim", "-s", "-r", ownWorld("pong_world.sdf"), "--iterations", "1", "-v", "2"},
                            {{"GZ_RELAY", "192.168.7.7"}});
  EXPECT_NE(warned.error.find("GZ_RELAY has no effect"), std::string::npos) << warned.error;
}

}  // namespace
}  // namespace pongsim::test
