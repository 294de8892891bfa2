#include "pongsim/lockstep_run.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace pongsim {
namespace {

TEST(LockstepTopic, NamesATopicAndHowOften) {
  const auto is = [](const char* text, const char* name, std::uint64_t every, std::uint64_t count) {
    const Outcome<LockstepOptions::Topic> topic = lockstepTopic(text);
    ASSERT_TRUE(topic) << topic.error;
    EXPECT_EQ(topic.value->name, name) << text;
    EXPECT_EQ(topic.value->every, every) << text;
    EXPECT_EQ(topic.value->count, count) << text;
  };
  is("/cmd_vel", "/cmd_vel", 1, 1);
  is("/cmd_vel:100", "/cmd_vel", 100, 1);
  is("/cmd_vel:100:3", "/cmd_vel", 100, 3);
  is("/model/a::b/cmd", "/model/a::b/cmd", 1, 1);
  is("/a:b:7", "/a:b", 7, 1);
}

TEST(LockstepTopic, SaysWhatIsWrong) {
  EXPECT_EQ(lockstepTopic("/cmd vel").error, "'/cmd vel' has a space");
  EXPECT_EQ(lockstepTopic("/cmd:0").error, "'/cmd:0' has '0' where a whole number from 1 belongs");
  EXPECT_EQ(lockstepTopic("/cmd:5:0").error, "'/cmd:5:0' has '0' where a whole number from 1 belongs");
  EXPECT_EQ(lockstepTopic("/cmd:99999999999999999999").error,
            "'/cmd:99999999999999999999' has '99999999999999999999' where a whole number from 1 belongs");
  EXPECT_EQ(lockstepTopic("/cmd:1:501").error, "at most 500 messages can be taken in at once, not 501");
}

TEST(LockstepTopic, HasANearestOneInTheWorld) {
  Transport transport({.network = false, .domain = {}});
  const Subscription taken = transport.node().subscribe("/cmd_vel", "Twist", [](const Message&) {});
  const Publisher published = transport.node().advertise("/lidar", "LaserScan");
  LockstepOptions options{.topics = {{"cmd_vel"}}, .heard = {"/lidar"}};
  EXPECT_TRUE(unknownLockstepTopics(options, transport.node()).empty());
  options = {.topics = {{"/cmd_vle"}, {"/sync"}}, .heard = {"/lidra"}};
  EXPECT_EQ(unknownLockstepTopics(options, transport.node()),
            (std::vector<std::string>{"no system of the world subscribes to '/cmd_vle': did you mean '/cmd_vel'?",
                                      "no system of the world subscribes to '/sync'",
                                      "no system of the world publishes on '/lidra': did you mean '/lidar'?"}));
}

class LockstepRunTest : public testing::Test {
 protected:
  LockstepRunTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "world.sdf",
                                       {.loadSystems = false}, diagnostics);
  }
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(LockstepRunTest, MakesAStepForEachMessage) {
  LockstepRun run(*simulation_, {.topics = {{"/push"}}, .heard = {}, .timeout = std::chrono::seconds(0)});
  Transport outside(simulation_->transport(), Transport::Sharing());
  Publisher push = outside.node().advertise("/push", "Int32");
  const auto goesOn = [] { return true; };
  for (int i = 0; i < 3; ++i) push.publish(*newMessage("Int32"));
  for (std::uint64_t i = 1; i <= 4; ++i) {
    const Outcome<bool> made = run.step(goesOn);
    ASSERT_TRUE(made) << made.error;
    EXPECT_TRUE(*made.value);
    EXPECT_EQ(simulation_->iterations(), i);
  }
  const Outcome<bool> late = run.step(goesOn);
  EXPECT_EQ(late.error, "lockstep: no message on '/push' for step 4 from this process within 0 s");
  EXPECT_EQ(simulation_->iterations(), 4U);
}

TEST_F(LockstepRunTest, EndsAWaitWhenItIsTold) {
  LockstepRun run(*simulation_, {.topics = {{"/push"}}, .heard = {}});
  std::atomic<int> asked = 0;
  const Outcome<bool> made = run.step([&asked] { return ++asked < 4; });
  ASSERT_TRUE(made);
  EXPECT_FALSE(*made.value);
  EXPECT_EQ(simulation_->iterations(), 0U);
}

}  // namespace
}  // namespace pongsim
