#include <ignition/msgs/model.pb.h>

#include <cmath>
#include <limits>

#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

using pongsim::test::RunningWorld;
using Words = std::vector<std::string>;

std::string plugin(const std::string& parameters) {
  return "<plugin filename='gz_ros2_control-system' name='gz_ros2_control::GazeboSimROS2ControlPlugin'>" + parameters +
         "</plugin>";
}

/// A model "m" whose joint "hinge" turns about z.
std::string modelWith(const std::string& parts, const std::string& name = "m") {
  return "<gravity>0 0 0</gravity><model name='" + name +
         "'><link name='base'/><link name='arm'><inertial><mass>1</mass><inertia>"
         "<ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link><joint name='hold' type='fixed'>"
         "<parent>world</parent><child>base</child></joint><joint name='hinge' type='revolute'><parent>base</parent>"
         "<child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>" +
         parts + "</model>";
}

const std::string kBlock =
    "<ros2_control><joint name='hinge'><command_interface name='position'/><state_interface name='position'/></joint>"
    "</ros2_control>";

std::string said(const std::function<void()>& act) {
  testing::internal::CaptureStderr();
  act();
  return testing::internal::GetCapturedStderr();
}

TEST(Ros2Control, TakesCommandsAndTellsStates) {
  RunningWorld world(modelWith(plugin(kBlock)));
  std::vector<ignition::msgs::Model> states;
  world.listen("/robot_joint_states", states);
  const std::string message = said([&] { world.step(1); });
  EXPECT_NE(
      message.find(
          "the controllers of 'm' run outside of the simulation: commands for hinge are read from "
          "'/robot_joint_commands', states are published on '/robot_joint_states'; run with --ros2 so that ROS nodes "
          "can reach these topics. In the URDF that ros2_control_node reads: "
          "<hardware><plugin>topic_based_ros2_control/TopicBasedSystem</plugin><param name=\"joint_commands_topic\">"),
      std::string::npos)
      << message;
  world.tellText("/robot_joint_commands", "ignition.msgs.Model",
                 "joint {name: 'hinge' axis1 {position: 0.5 velocity: nan force: nan}}");
  EXPECT_EQ(said([&] { world.step(2000); }), "");
  EXPECT_NEAR(world.model("m").joint("hinge")->position(), 0.5, 1e-6);
  // at 100 Hz
  EXPECT_NEAR(static_cast<double>(states.size()), 200, 2);
  ASSERT_EQ(states.back().joint_size(), 1);
  EXPECT_EQ(states.back().joint(0).name(), "hinge");
  EXPECT_NEAR(states.back().joint(0).axis1().position(), 0.5, 1e-6);
}

TEST(Ros2Control, RefusesWhatCannotBeMeantAndWarnsOfUnknownJoints) {
  RunningWorld world(modelWith(plugin(kBlock)));
  said([&] { world.step(1); });
  const auto tell = [&](const std::string& name, const std::string& position) {
    return said([&] {
      world.tellText("/robot_joint_commands", "ignition.msgs.Model",
                     "joint {name: '" + name + "' axis1 {position: " + position + " velocity: nan force: nan}}");
      world.step(20);
    });
  };
  EXPECT_NE(tell("hinge", "inf").find("it commands joint 'hinge' with an infinite or very large value"),
            std::string::npos);
  EXPECT_EQ(tell("hinge", "nan"), "");
  EXPECT_EQ(world.model("m").joint("hinge")->position(), 0);
  EXPECT_NE(tell("hing", "1").find("commands joint 'hing', which <ros2_control> does not list; did you mean 'hinge'?"),
            std::string::npos);
  EXPECT_EQ(tell("hing", "1"), "");
  tell("hinge", "1");
  EXPECT_GT(world.model("m").joint("hinge")->position(), 0.1);
}

TEST(Ros2Control, GivesASecondRobotTopicsOfItsOwn) {
  RunningWorld world(modelWith(plugin(kBlock), "a") + modelWith(plugin(kBlock), "b") +
                     modelWith(plugin("<ros><namespace>c</namespace></ros>" + kBlock), "c"));
  const std::string message = said([&] { world.step(1); });
  EXPECT_NE(message.find("controllers of 'b' run outside of the simulation: commands for hinge are read from "
                         "'/b/robot_joint_commands'"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("'/c/robot_joint_states'"), std::string::npos) << message;
}

TEST(Ros2Control, TakesTheBlockOfAUrdfAndTheRateOfItsControllers) {
  const pongsim::test::TempFolder folder;
  folder.write("c.yaml", "controller_manager:\n  ros__parameters:\n    update_rate: 500\n");
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial>";
  folder.write(
      "r.urdf",
      "<robot name='r'><link name='world'/><link name='base'>" + inertial + "</link><link name='arm'>" + inertial +
          "</link><joint name='hold' type='fixed'><parent link='world'/><child link='base'/></joint>"
          "<joint name='hinge' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/></joint>"
          "<ros2_control><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware><joint name='hinge'>"
          "<command_interface name='velocity'/><state_interface name='position'><param "
          "name='initial_value'>0.25</param>"
          "</state_interface></joint></ros2_control>"
          "<gazebo><plugin filename='libgz_ros2_control-system.so' name='ign_ros2_control::IgnitionROS2ControlPlugin'>"
          "<parameters>c.yaml</parameters></plugin></gazebo></robot>");
  RunningWorld world("<gravity>0 0 0</gravity><include><uri>" + (folder.path() / "r.urdf").string() +
                     "</uri></include>");
  std::vector<ignition::msgs::Model> states;
  world.listen("/robot_joint_states", states);
  said([&] { world.step(1); });
  EXPECT_NEAR(world.model("r").joint("hinge")->position(), 0.25, 1e-9);
  world.tellText("/robot_joint_commands", "ignition.msgs.Model",
                 "joint {name: 'hinge' axis1 {position: nan velocity: 2 force: nan}}");
  world.step(1000);
  EXPECT_NEAR(world.model("r").joint("hinge")->velocity(), 2, 1e-6);
  EXPECT_NEAR(static_cast<double>(states.size()), 500, 3);
}

TEST(Ros2Control, SaysWhatIsMissing) {
  EXPECT_EQ(
      RunningWorld::complaintsAbout(modelWith(plugin("<hold_joints>false</hold_joints>"))),
      Words{"gz_ros2_control-system of m is left out: there is no <ros2_control> that lists joints of model 'm'"});
  EXPECT_EQ(RunningWorld::complaintsAbout(
                modelWith(plugin("<ros2_control><joint name='hinge'/></ros2_control><parameters></parameters>"))),
            Words{"<parameters> is empty"});
  EXPECT_EQ(
      RunningWorld::complaintsAbout(modelWith(
          plugin("<ros2_control><joint name='hinge'/><joint name='hinges'/></ros2_control><parameters>none.yaml"
                 "</parameters>"))),
      (Words{"parameters 'none.yaml': there is no such file",
             "<ros2_control> lists joint 'hinges', which is not a joint of model 'm' with one axis: it is left out"}));
}

}  // namespace
}  // namespace pongsim::ros2
