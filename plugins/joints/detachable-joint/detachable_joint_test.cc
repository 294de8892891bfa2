#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::detachable_joint_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<model name="crane"><pose>0 0 3 0 0 0</pose><link name="hook"><inertial><mass>1</mass></inertial></link>
      <joint name="hold" type="fixed"><parent>world</parent><child>hook</child></joint>
      <plugin filename="ignition-gazebo-detachable-joint-system" name="ignition::gazebo::systems::DetachableJoint">)" +
         parameters + R"(</plugin></model>
    <model name="load"><pose>0.5 0 2 0 0 0</pose><link name="body"><inertial><mass>2</mass></inertial></link></model>)";
}

constexpr const char* kLoad =
    "<parent_link>hook</parent_link><child_model>load</child_model><child_link>body</child_link>";

double height(RunningWorld& world) { return world.model("load").pose().position.z(); }

std::vector<std::string> textsOf(const std::vector<ignition::msgs::StringMsg>& messages) {
  std::vector<std::string> texts;
  for (const auto& message : messages) texts.push_back(message.data());
  return texts;
}

TEST(DetachableJoint, HoldsUntilItIsToldToLetGo) {
  RunningWorld world(worldWith(kLoad));
  std::vector<ignition::msgs::StringMsg> states;
  world.listen("/model/load/detachable_joint/state", states);
  world.step(500);
  EXPECT_NEAR(height(world), 2, 1e-3);
  EXPECT_EQ(textsOf(states), std::vector<std::string>{"attached"});
  world.tell("/model/crane/detachable_joint/detach", ignition::msgs::Empty());
  world.step(500);
  EXPECT_NEAR(height(world), 2 - 9.8 / 8, 0.02);
  EXPECT_EQ(textsOf(states), (std::vector<std::string>{"attached", "detached"}));
}

TEST(DetachableJoint, TakesHoldAgainWhereTheChildIs) {
  RunningWorld world(worldWith(std::string(kLoad) + "<topic>let go</topic><attach_topic>hold</attach_topic>"
                                                    "<output_topic>held</output_topic>"));
  std::vector<ignition::msgs::StringMsg> states;
  world.listen("/held", states);
  world.step(10);
  world.tell("/let_go", ignition::msgs::Empty());
  world.step(300);
  const double fallen = height(world);
  EXPECT_LT(fallen, 1.7);
  world.tell("/hold", ignition::msgs::Empty());
  world.step(500);
  EXPECT_NEAR(height(world), fallen, 0.02);
  EXPECT_EQ(textsOf(states), (std::vector<std::string>{"attached", "detached", "attached"}));
}

TEST(DetachableJoint, HoldsOrDoesNotAsInASavedState) {
  RunningWorld world(worldWith(kLoad));
  world.step(10);
  const std::vector<std::byte> held = world.simulation().saveState();
  world.tell("/model/crane/detachable_joint/detach", ignition::msgs::Empty());
  world.step(10);
  const std::vector<std::byte> free = world.simulation().saveState();
  EXPECT_TRUE(world.simulation().restoreState(held));
  world.step(300);
  EXPECT_NEAR(height(world), 2, 1e-3);
  world.tell("/model/crane/detachable_joint/detach", ignition::msgs::Empty());
  world.step(300);
  EXPECT_LT(height(world), 1.7);
  EXPECT_TRUE(world.simulation().restoreState(free));
  world.step(300);
  EXPECT_LT(height(world), 1.7);
}

TEST(DetachableJoint, WarnsOnceOfAChildThatIsNotThere) {
  const std::string parameters =
      "<parent_link>hook</parent_link><child_model>truck</child_model><child_link>body</child_link>";
  testing::internal::CaptureStderr();
  RunningWorld world(worldWith(parameters));
  world.step(10);
  const std::string said = testing::internal::GetCapturedStderr();
  const std::string warning = "there is no model 'truck' to hold yet";
  ASSERT_NE(said.find(warning), std::string::npos) << said;
  EXPECT_EQ(said.find(warning, said.find(warning) + 1), std::string::npos) << said;

  testing::internal::CaptureStderr();
  RunningWorld quiet(worldWith(parameters + "<suppress_child_warning>true</suppress_child_warning>"));
  quiet.step(10);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(DetachableJoint, IsLeftOutWithTheReason) {
  const std::string left = "detachable-joint of crane is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<parent_link>rope</parent_link><child_model>load</child_model>"
                                                    "<child_link>body</child_link>")),
            std::vector<std::string>{left + "<parent_link> 'rope' is not a link of model 'crane'"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<parent_link>hook</parent_link>")),
            (std::vector<std::string>{left + "no <child_model> is given", left + "no <child_link> is given"}));
}

TEST(DetachableJoint, OfFortressExampleLetsTheBoxesFallAsTheWorldSays) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/triggered_publisher.sdf");
  const auto heightOf = [&](const char* model) { return world.model(model).pose().position.z(); };
  const double first = heightOf("box1"), second = heightOf("box2");
  world.step(1000);
  EXPECT_NEAR(heightOf("box1"), first, 1e-3);

  world.tell("/start", ignition::msgs::Empty());
  world.step(1500);  // at 3 m/s to the line, 3 m ahead
  EXPECT_LT(heightOf("box1"), first - 0.1);
  EXPECT_NEAR(heightOf("box2"), second, 1e-3);
  world.step(2000);  // the first box is down, and the second waits for five seconds
  EXPECT_NEAR(heightOf("box1"), 0.5, 0.01);
  EXPECT_NEAR(heightOf("box2"), second, 1e-3);
  world.step(6000);
  EXPECT_NEAR(heightOf("box2"), 0.5, 0.01);
}

}  // namespace
}  // namespace pongsim::detachable_joint_test
