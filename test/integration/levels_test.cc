// Levels and performers of a running world, controlled from the command line.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "integration/program.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

constexpr const char* kTwoHalls = R"(<sdf version="1.9"><world name="halls"><gravity>0 0 0</gravity>
  <model name="robot"><link name="l"/></model>
  <model name="near"><link name="l"/></model><model name="far"><pose>50 0 0 0 0 0</pose><link name="l"/></model>
  <plugin filename="dummy" name="gz::sim">
    <level name="one"><geometry><box><size>10 10 10</size></box></geometry><ref>near</ref></level>
    <level name="two"><pose>50 0 0 0 0 0</pose><geometry><box><size>10 10 10</size></box></geometry><ref>far</ref></level>
  </plugin></world></sdf>)";

class LevelsCommand : public testing::Test {
 protected:
  std::string list() {
    const Outcome outcome = runToEnd({"model", "--list", "--timeout", "60000"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    return outcome.output;
  }
  static Outcome call(const std::string& service, const std::string& request) {
    return runToEnd({"service", "-s", "/world/halls/" + service, "--timeout", "60000", "--req", request});
  }

  const TempFolder folder_;
  const std::string world_ = folder_.write("halls.sdf", kTwoHalls).string();
};

TEST_F(LevelsCommand, LoadsWhatIsNearThePerformersOnly) {
  const auto run = start({"run", world_, "-z", "100", "--levels", "-v", "3"});
  ASSERT_TRUE(run->waitForError("world 'halls': 1 model and 2 in levels not loaded, step")) << run->error();
  EXPECT_EQ(list(), "Available models:\n    - robot\n");
  const Outcome performs = call("level/set_performer", "data: 'robot'");
  EXPECT_EQ(performs.output, "data: true\n\n") << performs.error;
  ASSERT_TRUE(run->waitForError("level 'one' is loaded")) << run->error();
  EXPECT_EQ(list(), "Available models:\n    - robot\n    - near\n");
  const Outcome refused = call("remove", "name: 'far', type: MODEL");
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.error.find("model 'far' is in a level that is not loaded"), std::string::npos) << refused.error;
  EXPECT_EQ(call("set_pose", "name: 'robot', position {x: 50}").exitCode, 0);
  ASSERT_TRUE(run->waitForError("level 'two' is loaded")) << run->error();
  EXPECT_EQ(list(), "Available models:\n    - robot\n    - far\n");
  EXPECT_TRUE(run->waitForError("level 'one' is unloaded")) << run->error();
}

TEST_F(LevelsCommand, LoadsAllWithoutTheOption) {
  const Outcome outcome = runToEnd({"run", world_, "-z", "0", "--iterations", "1", "--strict"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("world 'halls': 3 models, step"), std::string::npos) << outcome.error;
}

TEST_F(LevelsCommand, SaysWhereAMistakeIs) {
  std::string text = kTwoHalls;
  text.replace(text.find("<ref>far</ref>"), 14, "<ref>fra</ref>");
  const Outcome outcome = runToEnd(
      {"run", folder_.write("wrong.sdf", text).string(), "-z", "0", "--iterations", "1", "--strict", "--levels"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find(
                "wrong.sdf:6:101: error: level 'two' names 'fra', which is not a model, light or actor of the world"),
            std::string::npos)
      << outcome.error;
  EXPECT_NE(outcome.error.find("did you mean 'far'?"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace pongsim::test
