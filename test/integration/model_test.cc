#include <gtest/gtest.h>
#include <signal.h>

#include <memory>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/regex.hh"

namespace pongsim::test {
namespace {

/// The pong world, paused.
class ModelCommand : public testing::Test {
 protected:
  Outcome model(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "model");
    arguments.insert(arguments.end(), {"--timeout", "60000"});
    return runToEnd(arguments);
  }

  std::unique_ptr<Process> world_ = startServedWorld("pong_world.sdf", {"--paused"});
};

TEST_F(ModelCommand, ListsModels) {
  const Outcome list = model({"--list"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  EXPECT_EQ(list.output, "Available models:\n    - ground_plane\n    - court\n    - pong_bot\n");
  EXPECT_EQ(list.error, "");
}

TEST_F(ModelCommand, TellsOfAModelAndItsParts) {
  const Outcome all = model({"-m", "pong_bot"});
  EXPECT_EQ(all.exitCode, 0) << all.error;
  EXPECT_TRUE(Regex("^Model: \\[\\d+\\]\n  - Name: pong_bot\n  - Pose \\[ XYZ"
                    " \\(m\\) \\] \\[ RPY \\(rad\\) \\]:\n    \\[")
                  .isIn(all.output))
      << all.output;
  EXPECT_NE(all.output.find("    - Name: left_wheel_joint\n"), std::string::npos) << all.output;
  const Outcome link = model({"-m", "pong_bot", "-l", "caster"});
  EXPECT_TRUE(link.output.starts_with("- Link [")) << link.output;
  EXPECT_EQ(link.output.find("chassis"), std::string::npos) << link.output;
  const Outcome joints = model({"-m", "pong_bot", "--joint"});
  EXPECT_NE(joints.output.find("  - Type: revolute\n"), std::string::npos) << joints.output;
  const Outcome json = model({"-m", "pong_bot", "-p", "--json"});
  EXPECT_TRUE(json.output.starts_with("{\"name\":\"pong_bot\",\"id\":")) << json.output;
}

TEST_F(ModelCommand, SaysWhatIsNotThere) {
  const Outcome wrong = model({"-m", "pong_bott"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.output, "");
  EXPECT_EQ(wrong.error,
            "pongsim: error: world 'pong_world' has no model 'pong_bott'\n  hint: did you mean 'pong_bot'?\n");
  const Outcome link = model({"-m", "pong_bot", "-l", "chasis"});
  EXPECT_EQ(link.exitCode, 1);
  EXPECT_EQ(link.error, "pongsim: error: model 'pong_bot' has no link 'chasis'\n  hint: did you mean 'chassis'?\n");
}

TEST_F(ModelCommand, GoesOnPrinting) {
  const Outcome twice = model({"-m", "pong_bot", "-p", "--follow", "-n", "2"});
  EXPECT_EQ(twice.exitCode, 0) << twice.error;
  EXPECT_EQ(Regex("Model: \\[").allIn(twice.output).size(), 2U);
  EXPECT_EQ(runToEnd({"world", "play"}).exitCode, 0);
  const auto followed = start({"model", "-m", "pong_bot", "-p", "--follow", "--json", "--timeout", "60000"});
  ASSERT_TRUE(followed->waitForOutput("\n[^]*\n[^]*\n")) << followed->error();
  followed->kill(SIGINT);
  EXPECT_EQ(followed->wait(), 0) << followed->error();
}

TEST(ModelCommandAlone, SaysWhereAWorldDoesNotTellItsState) {
  const Outcome none = runToEnd({"model", "--list", "--timeout", "0"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_EQ(none.error, "pongsim: error: no world is running\n  hint: start one with pongsim run WORLD\n");
}

}  // namespace
}  // namespace pongsim::test
