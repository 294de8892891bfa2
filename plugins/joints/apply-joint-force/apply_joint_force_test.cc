#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::apply_joint_force_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<gravity>0 0 0</gravity><model name="m">
    <link name="base"><inertial><mass>1</mass></inertial></link>
    <link name="cart"><inertial><mass>2</mass></inertial></link>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="rail" type="prismatic"><parent>base</parent><child>cart</child><axis><xyz>1 0 0</xyz></axis></joint>
    <plugin filename="ignition-gazebo-apply-joint-force-system" name="ignition::gazebo::systems::ApplyJointForce">)" +
         parameters + "</plugin></model>";
}

constexpr const char* kJoint = "<joint_name>rail</joint_name>";
constexpr const char* kTopic = "/model/m/joint/rail/cmd_force";

ignition::msgs::Double number(double value) {
  ignition::msgs::Double message;
  message.set_data(value);
  return message;
}

TEST(ApplyJointForce, PushesUntilItIsToldOtherwise) {
  RunningWorld world(worldWith(kJoint));
  world.step(100);
  EXPECT_EQ(world.model("m").joint("rail")->velocity(), 0);
  world.tell(kTopic, number(4));
  world.step(1000);
  EXPECT_NEAR(world.model("m").joint("rail")->velocity(), 2, 1e-3);
  world.tell(kTopic, number(0));
  world.step(1000);
  EXPECT_NEAR(world.model("m").joint("rail")->velocity(), 2, 1e-3);
}

TEST(ApplyJointForce, RefusesAbsurdForcesAndGoesOn) {
  RunningWorld world(worldWith(kJoint));
  world.tellAbsurdities(kTopic, "ignition.msgs.Double", "data: #", "1e+08");
  EXPECT_EQ(world.model("m").joint("rail")->velocity(), 0);
  world.tell(kTopic, number(4));
  world.step(1000);
  EXPECT_NEAR(world.model("m").joint("rail")->velocity(), 2, 1e-3);
}

TEST(ApplyJointForce, IsLeftOutWithoutAJoint) {
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("")),
            std::vector<std::string>{"apply-joint-force of m is left out: no <joint_name> is given"});
}

}  // namespace
}  // namespace pongsim::apply_joint_force_test
