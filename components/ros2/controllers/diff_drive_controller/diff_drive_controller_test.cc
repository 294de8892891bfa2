#include "ros2/controllers/diff_drive_controller/diff_drive_controller.hh"

#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <cmath>

#include "support/fortress_worlds.hh"
#include "support/ros2/controlled_robot.hh"
#include "support/running_world.hh"

namespace pongsim::ros2 {
namespace {

std::filesystem::path example() { return test::projectFolder() / "plugins/drives/diff-drive/diff_drive.sdf"; }

/// The example of the system DiffDrive, whose wheels are 0.4 m apart with a radius of 0.1 m.
ControlledRobot rover(const std::string& parameters, double rate = 1000) {
  return {test::worldOfFile(example()), "rover",
          "controller_manager:\n  ros__parameters:\n    drive: {type: diff_drive_controller/DiffDriveController}\n"
          "drive:\n  ros__parameters:\n    left_wheel_names: [left_wheel_joint]\n"
          "    right_wheel_names: [right_wheel_joint]\n    wheel_separation: 0.4\n    wheel_radius: 0.1\n" +
              parameters,
          rate};
}

geometry_msgs::TwistStamped twist(double linear, double angular) {
  geometry_msgs::TwistStamped message;
  message.twist.linear.x = linear;
  message.twist.angular.z = angular;
  return message;
}

TEST(DiffDriveController, DrivesTheSamePathAsTheSystem) {
  ControlledRobot robot = rover(
      "    cmd_vel_timeout: 0.0\n    linear.x.max_velocity: 1.0\n    linear.x.max_acceleration: 2.0\n"
      // the system brakes without a limit
      "    linear.x.max_deceleration: -1000.0\n");
  test::RunningWorld world(example());
  robot.start("drive");
  robot.step(100);
  world.step(100);
  double length = 0;
  for (const auto& [linear, angular] : {std::pair{0.8, 0.3}, std::pair{0.5, -0.6}, std::pair{0.0, 0.5}}) {
    robot.tell("/drive/cmd_vel", twist(linear, angular));
    world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist",
                   "linear {x: " + std::to_string(linear) + "} angular {z: " + std::to_string(angular) + "}");
    robot.step(3000);
    world.step(3000);
    length += 3 * linear;
    const Pose is = robot.model().pose(), expected = world.model("rover").pose();
    EXPECT_LT((is.position - expected.position).norm(), 0.01 * length);
    EXPECT_LT(is.rotation.angularDistance(expected.rotation), 0.01);
  }
}

TEST(DiffDriveController, ComputesOdometryByTheArcOfACircle) {
  for (const std::string feedback : {"position_feedback: true", "position_feedback: false"}) {
    ControlledRobot robot = rover("    cmd_vel_timeout: 0.0\n    publish_rate: 100.0\n    " + feedback + "\n");
    robot.start("drive");
    const auto odometry = robot.listen<nav_msgs::Odometry>("/drive/odom");
    robot.step(100);
    robot.tell("/drive/cmd_vel", twist(0.5, 0.4));
    robot.step(2000);
    const nav_msgs::Odometry last = robot.next(*odometry);
    // commanded from 0.1 s on, and from there with a step's delay
    const double t = last.header.stamp.sec + last.header.stamp.nanosec * 1e-9 - 0.1;
    EXPECT_NEAR(last.pose.pose.position.x, 0.5 / 0.4 * std::sin(0.4 * t), 0.005);
    EXPECT_NEAR(last.pose.pose.position.y, 0.5 / 0.4 * (1 - std::cos(0.4 * t)), 0.005);
    EXPECT_NEAR(2 * std::atan2(last.pose.pose.orientation.z, last.pose.pose.orientation.w), 0.4 * t, 0.005);
    EXPECT_NEAR(last.twist.twist.linear.x, 0.5, 0.005);
    EXPECT_NEAR(last.twist.twist.angular.z, 0.4, 0.005);
    EXPECT_EQ(last.header.frame_id, "odom");
    EXPECT_EQ(last.child_frame_id, "base_link");
  }
}

TEST(DiffDriveController, BrakesWithinItsLimitsWhenCommandsEnd) {
  ControlledRobot robot = rover(
      "    linear.x.max_velocity: 0.6\n    linear.x.max_acceleration: 1.0\n    linear.x.max_deceleration: -2.0\n"
      "    publish_limited_velocity: true\n    open_loop: true\n");
  robot.start("drive");
  const auto limited = robot.listen<geometry_msgs::TwistStamped>("/drive/cmd_vel_out");
  robot.step(10);
  robot.tell("/drive/cmd_vel", twist(5, 0));
  std::vector<double> speeds;
  for (int i = 0; i < 1200; ++i) {
    robot.step();
    speeds.push_back(0.1 * robot.hardware().command("left_wheel_joint/velocity")->get());
  }
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    EXPECT_LE(speeds[i] - speeds[i - 1], 0.001 + 1e-9);
    EXPECT_GE(speeds[i] - speeds[i - 1], -0.002 - 1e-9);
  }
  EXPECT_NEAR(*std::ranges::max_element(speeds), 0.5, 0.01);
  // after 0.5 s without a command
  EXPECT_EQ(speeds.back(), 0);
  EXPECT_EQ(robot.next(*limited).twist.linear.x, 0);
  EXPECT_NEAR(robot.model().joint("left_wheel_joint")->velocity(), 0, 1e-3);
}

TEST(DiffDriveController, TakesUnstampedCommandsWhereItIsToldTo) {
  ControlledRobot robot = rover("    use_stamped_vel: false\n");
  robot.start("drive");
  robot.step(10);
  geometry_msgs::Twist command;
  command.linear.x = 0.3;
  robot.tell("/drive/cmd_vel_unstamped", command);
  robot.step(300);
  EXPECT_NEAR(robot.model().joint("left_wheel_joint")->velocity(), 3, 0.01);
}

TEST(DiffDriveController, GoesOnFromASavedState) {
  ControlledRobot robot = rover("    cmd_vel_timeout: 0.0\n    linear.x.max_acceleration: 0.2\n", 250);
  robot.start("drive");
  robot.tell("/drive/cmd_vel", twist(1, 0.3));
  robot.step(1001);
  const auto saved = robot.save();
  robot.step(777);
  const Pose first = robot.model().pose();
  robot.restore(saved);
  robot.step(777);
  EXPECT_EQ(robot.model().pose().position, first.position);
  EXPECT_EQ(robot.model().pose().rotation.coeffs(), first.rotation.coeffs());
  // a state is that of the same controllers
  EXPECT_EQ(robot.manager().switchTo({}, {"drive"}, true).error, "");
  EXPECT_THROW(robot.restore(saved), std::out_of_range);
}

TEST(DiffDriveController, SaysWhatIsWrongWithItsParameters) {
  ControlledRobot robot = rover("    wheel_radius: -1\n    left_wheel_names: []\n");
  EXPECT_EQ(robot.manager().load("drive").error, "");
  EXPECT_EQ(robot.manager().configure("drive").error,
            "controller 'drive': parameter 'left_wheel_names' and 'right_wheel_names' must have the same number of "
            "joints, at least one, 'wheel_radius' must be above zero");
  EXPECT_EQ(robot.manager().switchTo({"drive"}, {}, true).error, "controller 'drive' is not configured");
}

}  // namespace
}  // namespace pongsim::ros2
