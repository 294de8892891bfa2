#include "ros2/control/joint_commands.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pongsim::ros2 {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
using Words = std::vector<std::string>;

/// A message as made by the bridge, from names and lists that may be shorter.
ignition::msgs::Model messageOf(const Words& names, std::vector<double> positions,
                                std::vector<double> velocities = {}) {
  ignition::msgs::Model message;
  positions.resize(names.size(), kNothing);
  velocities.resize(names.size(), kNothing);
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& joint = *message.add_joint();
    joint.set_name(names[i]);
    joint.mutable_axis1()->set_position(positions[i]);
    joint.mutable_axis1()->set_velocity(velocities[i]);
    joint.mutable_axis1()->set_force(kNothing);
  }
  return message;
}

/// A wheel, an arm, a wheel.
std::vector<ControlledJoint> robot() {
  std::vector<ControlledJoint> joints(3);
  joints[0].name = "left";
  joints[0].takesVelocity = true;
  joints[1].name = "arm";
  joints[1].takesPosition = true;
  joints[2].name = "right";
  joints[2].takesVelocity = true;
  return joints;
}

TEST(JointCommands, GoByTheNames) {
  Words unknown;
  const auto commands = readCommands(messageOf({"right", "arm"}, {1, 2}, {3, 4}), robot(), unknown);
  EXPECT_EQ(unknown, Words());
  ASSERT_EQ(commands.size(), 3U);
  EXPECT_EQ(commands[0].velocity, std::nullopt);
  EXPECT_EQ(commands[1].position, 2);
  // interfaces that it does not have are ignored
  EXPECT_EQ(commands[1].velocity, std::nullopt);
  EXPECT_EQ(commands[2].velocity, 3);
  EXPECT_EQ(commands[2].position, std::nullopt);
  EXPECT_EQ(commands[2].effort, std::nullopt);
}

TEST(JointCommands, GoByTheJointsWithTheInterfaceAsTopicBasedRos2ControlSendsThem) {
  Words unknown;
  const auto commands = readCommands(messageOf({"left", "arm", "right"}, {1}, {2, 3}), robot(), unknown);
  EXPECT_EQ(commands[0].velocity, 2);
  EXPECT_EQ(commands[1].position, 1);
  EXPECT_EQ(commands[2].velocity, 3);
}

TEST(JointCommands, TellWhichJointsAreUnknown) {
  Words unknown;
  const auto commands = readCommands(messageOf({"lift", "arm"}, {1, 2}), robot(), unknown);
  EXPECT_EQ(unknown, Words{"lift"});
  EXPECT_EQ(commands[1].position, 2);
  EXPECT_EQ(nearestName("lift", {"arm", "left", "right"}), "left");
  EXPECT_EQ(nearestName("elevator", {"arm", "left", "right"}), "");
}

}  // namespace
}  // namespace pongsim::ros2
