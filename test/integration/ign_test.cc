// Tests the program under the name `ign`, as scripts for Fortress use it.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
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
    std::filesystem::create_symlink(PONGSIM_PROGRAM, link_);
  }

  Outcome ign(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment = {}) {
    arguments.insert(arguments.begin(), link_);
    Process process(arguments, {.environment = environment, .folder = folder_.path()});
    return {process.wait().value_or(-1), process.output(), process.error()};
  }

  TempFolder folder_;
  std::string link_ = (folder_.path() / "ign").string();
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

}  // namespace
}  // namespace pongsim::test
