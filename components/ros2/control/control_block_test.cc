#include "ros2/control/control_block.hh"

#include "pongsim/files/urdf_source.hh"
#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

using Words = std::vector<std::string>;

/// The blocks of a URDF with some joints.
struct Read {
  Diagnostics diagnostics;
  std::vector<ControlBlock> blocks;

  explicit Read(const std::string& parts) {
    const auto simulation = test::worldOf(
        "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
        "iyz='0'/></inertial></link>\n" +
        parts + "</robot>");
    blocks = controlBlocks(simulation->world().model("r")->urdf()->robot, diagnostics);
  }
  Words messages() const {
    Words all;
    for (const Diagnostic& each : diagnostics.all()) all.push_back(format(each));
    return all;
  }
};

TEST(ControlBlock, ListsJointsWithTheirInterfaces) {
  const Read read(
      "<ros2_control name='s' type='system'><hardware><plugin>p</plugin><param name='joint_commands_topic'>/c</param>"
      "<param name='joint_states_topic'>/s</param></hardware><joint name='j'><command_interface name='position'/>"
      "<command_interface name='effort'/><state_interface name='position'><param name='initial_value'>0.25</param>"
      "</state_interface><state_interface name='velocity'/></joint><joint name='k'>"
      "<command_interface name='velocity'/></joint></ros2_control>");
  EXPECT_EQ(read.messages(), Words());
  ASSERT_EQ(read.blocks.size(), 1U);
  EXPECT_EQ(read.blocks[0].commandsTopic, "/c");
  EXPECT_EQ(read.blocks[0].statesTopic, "/s");
  ASSERT_EQ(read.blocks[0].joints.size(), 2U);
  const ControlledJoint& joint = read.blocks[0].joints[0];
  EXPECT_EQ(joint.name, "j");
  EXPECT_TRUE(joint.takesPosition);
  EXPECT_FALSE(joint.takesVelocity);
  EXPECT_TRUE(joint.takesEffort);
  EXPECT_EQ(joint.initialPosition, 0.25);
  EXPECT_EQ(joint.initialVelocity, std::nullopt);
  EXPECT_TRUE(read.blocks[0].joints[1].takesVelocity);
}

TEST(ControlBlock, PutsThoseOfTheSameTopicsTogether) {
  const Read read(
      "<ros2_control><joint name='j'/></ros2_control><ros2_control><hardware>"
      "<param name='joint_commands_topic'>/c</param></hardware><joint name='k'/></ros2_control>"
      "<ros2_control><joint name='l'/></ros2_control>");
  ASSERT_EQ(read.blocks.size(), 2U);
  EXPECT_EQ(read.blocks[0].joints.size(), 2U);
  EXPECT_EQ(read.blocks[1].commandsTopic, "/c");
}

TEST(ControlBlock, FollowsAnotherJointAsTheBlockOrTheRobotSays) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  const Read read(
      "<link name='b'>" + inertial + "</link><link name='c'>" + inertial +
      "</link><joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint>"
      "<joint name='k' type='continuous'><parent link='a'/><child link='c'/>"
      "<mimic joint='j' multiplier='-2' offset='0.5'/></joint>"
      "<ros2_control><joint name='j'><param name='mimic'>k</param><param name='multiplier'>3</param></joint>"
      "<joint name='k'/></ros2_control>");
  EXPECT_EQ(read.messages(), Words());
  ASSERT_EQ(read.blocks.at(0).joints.size(), 2U);
  EXPECT_EQ(read.blocks[0].joints[0].mimic->joint, "k");
  EXPECT_EQ(read.blocks[0].joints[0].mimic->multiplier, 3);
  EXPECT_EQ(read.blocks[0].joints[1].mimic->joint, "j");
  EXPECT_EQ(read.blocks[0].joints[1].mimic->multiplier, -2);
  EXPECT_EQ(read.blocks[0].joints[1].mimic->offset, 0.5);
}

TEST(ControlBlock, SaysWhereItIsWrong) {
  const Read read(
      "<ros2_control><joint name='j'>\n<command_interface name='acceleration'/>\n<state_interface name='position'>"
      "<param name='initial_value'>much</param></state_interface></joint></ros2_control>");
  const Words messages = read.messages();
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_TRUE(
      messages[0].starts_with("world.sdf:3:1: warning: joint 'j' can't be commanded by 'acceleration': it is ignored"))
      << messages[0];
  EXPECT_TRUE(messages[1].starts_with("world.sdf:4:34: error: 'much' is not a finite number")) << messages[1];
  EXPECT_EQ(read.blocks.at(0).joints.at(0).initialPosition, std::nullopt);
}

}  // namespace
}  // namespace pongsim::ros2
