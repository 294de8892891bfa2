#include "ros2/controllers/controller_manager.hh"

#include <chrono>
#include <cmath>
#include <fstream>
#include <future>

#include "ros2/controllers/controller_types.hh"
#include "ros2/controllers/manager_services.hh"
#include "ros2/types/control_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "support/ros2/controlled_robot.hh"

namespace pongsim::ros2 {
namespace {

using Words = std::vector<std::string>;
using State = ControllerManager::State;

std::string turningLink(const std::string& name, const std::string& side) {
  return "<link name='" + name + "_link'><pose>" + side +
         " 0 0 0 0 0</pose><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia>"
         "</inertial></link><joint name='" +
         name + "' type='revolute'><parent>base</parent><child>" + name +
         "_link</child><axis><xyz>0 0 1</xyz></axis></joint>";
}

ControlledRobot robotWith(const std::string& parameters, double rate = 1000, const std::string& remap = "") {
  return {test::worldOf(test::inWorld("<model name='m'><link name='base'/><joint name='hold' type='fixed'>"
                                      "<parent>world</parent><child>base</child></joint>" +
                                      turningLink("a", "1") + turningLink("b", "-1") + "</model>")),
          "m", parameters, rate, remap};
}

const std::string kThree =
    "controller_manager:\n  ros__parameters:\n"
    "    speeds: {type: velocity_controllers/JointGroupVelocityController}\n"
    "    pushes: {type: effort_controllers/JointGroupEffortController}\n"
    "    places: {type: forward_command_controller/ForwardCommandController}\n"
    "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n"
    "    odd: {type: odd_controllers/Odd}\n"
    "speeds:\n  ros__parameters:\n    joints: [a, b]\n    unknown: 1\n"
    "pushes:\n  ros__parameters:\n    joints: [b]\n"
    "places:\n  ros__parameters:\n    joints: [a]\n    interface_name: position\n"
    "bare:\n  ros__parameters:\n    type: joint_state_broadcaster/JointStateBroadcaster\n    extra_joints: [c]\n";

std_msgs::Float64MultiArray numbers(std::vector<double> values) {
  std_msgs::Float64MultiArray message;
  message.data = std::move(values);
  return message;
}

TEST(ControllerManager, SwitchesControllersThatNeedTheSameJoints) {
  ControlledRobot robot = robotWith(kThree);
  ControllerManager& manager = robot.manager();
  robot.start("speeds");
  EXPECT_EQ(robot.hardware().command("b/velocity")->owner, "speeds");
  // another interface of the joint is another resource
  robot.start("pushes");
  ASSERT_EQ(manager.load("places").error, "");
  EXPECT_EQ(manager.switchTo({"places"}, {}, true).error, "controller 'places' is not configured");
  ASSERT_EQ(manager.configure("places").error, "");
  EXPECT_EQ(manager.switchTo({"nobody"}, {}, true).error, "controller 'nobody' is not loaded");
  EXPECT_EQ(manager.switchTo({"speeds"}, {}, true).error, "controller 'speeds' is already active");
  EXPECT_EQ(manager.unload("speeds").error, "controller 'speeds' is active; deactivate it first");
  EXPECT_EQ(manager.configure("speeds").error, "controller 'speeds' is active and can't be configured");
  // nothing of a strict switch is done if a part can't be
  EXPECT_NE(manager.switchTo({"places"}, {"nobody"}, true).error, "");
  EXPECT_EQ(manager.controllers().back().state, State::kInactive);
  EXPECT_EQ(manager.switchTo({"places"}, {"nobody"}, false).error, "");
  EXPECT_EQ(manager.controllers().back().state, State::kActive);
  EXPECT_EQ(manager.switchTo({}, {"speeds", "places", "pushes"}, true).error, "");
  EXPECT_EQ(robot.hardware().command("b/velocity")->owner, "");
  EXPECT_EQ(manager.unload("speeds").error, "");
  EXPECT_EQ(manager.unload("speeds").error, "controller 'speeds' is not loaded");
}

TEST(ControllerManager, RefusesAJointThatIsTaken) {
  ControlledRobot robot = robotWith(kThree +
                                    "more:\n  ros__parameters:\n"
                                    "    type: velocity_controllers/JointGroupVelocityController\n    joints: [b]\n");
  robot.start("speeds");
  ASSERT_EQ(robot.manager().load("more").error, "");
  ASSERT_EQ(robot.manager().configure("more").error, "");
  EXPECT_EQ(robot.manager().switchTo({"more"}, {}, true).error,
            "controller 'more' needs command interface 'b/velocity', which controller 'speeds' holds");
  EXPECT_EQ(robot.manager().switchTo({"more"}, {"speeds"}, true).error, "");
}

TEST(ControllerManager, SaysWhichClassesItDoesNotKnow) {
  ControlledRobot robot = robotWith(kThree);
  EXPECT_EQ(robot.manager().unknownTypes(),
            (std::vector<std::pair<std::string, std::string>>{{"odd", "odd_controllers/Odd"}}));
  EXPECT_EQ(robot.manager().load("odd").error,
            "controller 'odd' is a odd_controllers/Odd, which does not run inside the simulation; "
            "~/list_controller_types has those that do");
  EXPECT_EQ(robot.manager().load("none").error,
            "controller 'none' has no 'type' in the parameters of '/controller_manager'");
  for (const ControllerType& type : controllerTypes()) EXPECT_NE(makeController(type.name), nullptr) << type.name;
}

TEST(ControllerManager, RefusesNamesThatAreNone) {
  ControlledRobot robot = robotWith(kThree, 1000, "~/commands:=/no-name");
  EXPECT_EQ(robot.manager().load("a-b").error,
            "controller 'a-b': its name has a '-', which ROS does not allow in names");
  ASSERT_EQ(robot.manager().load("speeds").error, "");
  EXPECT_EQ(robot.manager().configure("speeds").error,
            "controller 'speeds': topic '/no-name' has a '-', which ROS does not allow in names");
}

TEST(ControllerManager, TakesFilesThatASpawnerNames) {
  ControlledRobot robot = robotWith("controller_manager:\n  ros__parameters: {}\n");
  std::ofstream(robot.folder() / "late.yaml")
      << "late:\n  ros__parameters:\n    type: velocity_controllers/JointGroupVelocityController\n    joints: [a]\n";
  RosClient<rcl_interfaces::srv::SetParameters> client(robot.peer(), "/controller_manager/set_parameters");
  rcl_interfaces::srv::SetParameters::Request request;
  request.parameters = {{"late.params_file", parameterOf((robot.folder() / "late.yaml").string())}};
  auto answer = std::async(std::launch::async, [&] { return client.call(request, test::kDeadline); });
  while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) robot.manager().dispatch();
  EXPECT_TRUE(answer.get()->results.at(0).successful);
  robot.start("late");
}

TEST(ForwardCommandController, CommandsPositionsVelocitiesAndEfforts) {
  ControlledRobot robot = robotWith(kThree);
  robot.start("speeds");
  robot.step(10);
  robot.tell("/speeds/commands", numbers({1, -2}));
  robot.step(100);
  EXPECT_NEAR(robot.model().joint("a")->velocity(), 1, 1e-6);
  EXPECT_NEAR(robot.model().joint("b")->velocity(), -2, 1e-6);
  // ignored
  robot.tell("/speeds/commands", numbers({1}));
  robot.tell("/speeds/commands", numbers({NAN, 0}));
  robot.step(100);
  EXPECT_NEAR(robot.model().joint("b")->velocity(), -2, 1e-6);
  // joints without a controller are held
  ASSERT_EQ(robot.manager().switchTo({}, {"speeds"}, true).error, "");
  robot.step(100);
  EXPECT_NEAR(robot.model().joint("b")->velocity(), 0, 1e-6);
  robot.start("places");
  robot.tell("/places/commands", numbers({0.5}));
  robot.start("pushes");
  robot.tell("/pushes/commands", numbers({0.3}));
  robot.step(100);
  // 0.3 N m on 0.1 kg m^2, from the second of 100 steps on
  EXPECT_NEAR(robot.model().joint("b")->velocity(), 0.3 / 0.1 * 0.099, 1e-6);
  robot.step(200);
  EXPECT_NEAR(robot.model().joint("a")->position(), 0.5, 1e-3);
}

TEST(JointStateBroadcaster, PublishesAllStates) {
  ControlledRobot robot = robotWith(kThree, 100);
  robot.start("states");
  EXPECT_EQ(robot.manager().replacedTopics(), Words{"/joint_states"});
  const auto heard = robot.listen<sensor_msgs::JointState>("/joint_states");
  const auto dynamic = robot.listen<control_msgs::DynamicJointState>("/dynamic_joint_states");
  robot.start("speeds");
  robot.tell("/speeds/commands", numbers({1, -2}));
  robot.step(1000);
  const sensor_msgs::JointState last = robot.next(*heard);
  EXPECT_EQ(last.name, (Words{"a", "b"}));
  const double seconds = last.header.stamp.sec + last.header.stamp.nanosec * 1e-9;
  // at 100 Hz
  EXPECT_NEAR(std::remainder(seconds, 0.01), 0, 1e-9);
  // it turns from the second update on
  EXPECT_NEAR(last.position[0], seconds - 0.01, 1e-3);
  EXPECT_NEAR(last.velocity[1], -2, 1e-6);
  EXPECT_EQ(robot.next(*dynamic).interface_values[0].interface_names, (Words{"effort", "position", "velocity"}));
}

TEST(JointStateBroadcaster, AddsExtraJoints) {
  ControlledRobot robot = robotWith(kThree);
  robot.start("bare");
  const auto heard = robot.listen<sensor_msgs::JointState>("/joint_states");
  const sensor_msgs::JointState last = robot.next(*heard);
  EXPECT_EQ(last.name, (Words{"a", "b", "c"}));
  EXPECT_EQ(last.position[2], 0);
}

}  // namespace
}  // namespace pongsim::ros2
