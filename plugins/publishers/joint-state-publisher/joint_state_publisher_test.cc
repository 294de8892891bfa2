#include <gtest/gtest.h>
#include <ignition/msgs/model.pb.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::joint_state_publisher_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m"><pose>1 2 3 0 0 0</pose>
    <link name="base"><inertial><mass>1</mass></inertial></link>
    <link name="arm"><inertial><mass>1</mass></inertial></link>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><pose>0 0 0.5 0 0 0</pose><parent>base</parent><child>arm</child>
      <axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>2</upper></limit><dynamics><damping>0.5</damping></dynamics>
      </axis></joint>
    <plugin filename="ignition-gazebo-joint-state-publisher-system"
            name="ignition::gazebo::systems::JointStatePublisher">)" +
         parameters + "</plugin></model>";
}

constexpr const char* kTopic = "/world/w/model/m/joint_state";

TEST(JointStatePublisher, TellsOfAllJointsInEachStep) {
  RunningWorld world(worldWith(""));
  std::vector<ignition::msgs::Model> messages;
  world.listen(kTopic, messages);
  world.model("m").joint("hinge")->setVelocityTarget(0.5);
  world.step(100);
  ASSERT_EQ(messages.size(), 100U);
  const ignition::msgs::Model& last = messages.back();
  EXPECT_EQ(last.name(), "m");
  EXPECT_EQ(last.id(), world.model("m").id().value);
  EXPECT_NEAR(last.pose().position().y(), 2, 1e-9);
  EXPECT_EQ(last.header().stamp().nsec(), 100'000'000);
  ASSERT_EQ(last.joint_size(), 2);
  EXPECT_EQ(last.joint(0).name(), "hold");
  EXPECT_EQ(last.joint(0).parent(), "world");
  EXPECT_FALSE(last.joint(0).has_axis1());
  const ignition::msgs::Joint& hinge = last.joint(1);
  EXPECT_EQ(hinge.name(), "hinge");
  EXPECT_EQ(hinge.parent(), "base");
  EXPECT_EQ(hinge.child(), "arm");
  EXPECT_EQ(hinge.pose().position().z(), 0.5);
  EXPECT_EQ(hinge.axis1().xyz().y(), 1);
  EXPECT_EQ(hinge.axis1().limit_lower(), -1);
  EXPECT_EQ(hinge.axis1().limit_upper(), 2);
  EXPECT_EQ(hinge.axis1().damping(), 0.5);
  EXPECT_NEAR(hinge.axis1().velocity(), 0.5, 1e-6);
  EXPECT_NEAR(hinge.axis1().position(), 0.05, 1e-3);
}

TEST(JointStatePublisher, TellsOfTheJointsItIsToldAtItsRate) {
  RunningWorld world(worldWith("<joint_name>hinge</joint_name><update_rate>10</update_rate><topic>joints</topic>"));
  std::vector<ignition::msgs::Model> messages;
  world.listen("/joints", messages);
  world.step(1000);
  EXPECT_EQ(messages.size(), 11U);
  ASSERT_EQ(messages.back().joint_size(), 1);
  EXPECT_EQ(messages.back().joint(0).name(), "hinge");
}

TEST(JointStatePublisher, SpeaksWhilePaused) {
  RunningWorld world(worldWith(""));
  std::vector<ignition::msgs::Model> messages;
  world.listen(kTopic, messages);
  world.simulation().stepPaused();
  world.simulation().stepPaused();
  EXPECT_EQ(messages.size(), 1U);
}

TEST(JointStatePublisher, WarnsOfAJointThatIsNotThere) {
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<joint_name>knee</joint_name>")),
            std::vector<std::string>{"<joint_name> 'knee' is not a joint of model 'm'"});
}

}  // namespace
}  // namespace pongsim::joint_state_publisher_test
