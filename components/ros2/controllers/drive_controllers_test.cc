// Drives by controllers: wheels and odometry, by their formulas.
#include <cmath>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/nav_msgs.hh"
#include "support/ros2/controlled_robot.hh"

namespace pongsim::ros2 {
namespace {

/// A link on a joint, for each name, without contact with anything.
std::string spinning(const std::vector<std::string>& names) {
  std::string model =
      "<model name='m'><link name='base'/><joint name='hold' type='fixed'><parent>world</parent>"
      "<child>base</child></joint>";
  for (const std::string& name : names) {
    model += "<link name='" + name +
             "_link'><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy>"
             "<izz>0.1</izz></inertia></inertial></link><joint name='" +
             name + "' type='revolute'><parent>base</parent><child>" + name +
             "_link</child><axis><xyz>0 1 0</xyz></axis></joint>";
  }
  return test::inWorld(model + "</model>");
}

geometry_msgs::TwistStamped twist(double x, double y, double turn) {
  geometry_msgs::TwistStamped message;
  message.twist.linear = {x, y, 0};
  message.twist.angular = {0, 0, turn};
  return message;
}

TEST(MecanumDriveController, DrivesWheelsAndComputesOdometryByTheirKinematics) {
  ControlledRobot robot(
      test::worldOf(spinning({"fl", "fr", "rr", "rl"})), "m",
      "controller_manager:\n  ros__parameters:\n    drive: {type: mecanum_drive_controller/MecanumDriveController}\n"
      "drive:\n  ros__parameters:\n    reference_timeout: 100.0\n"
      "    front_left_wheel_command_joint_name: fl\n    front_right_wheel_command_joint_name: fr\n"
      "    rear_right_wheel_command_joint_name: rr\n    rear_left_wheel_command_joint_name: rl\n"
      "    kinematics:\n      wheels_radius: 0.1\n      sum_of_robot_center_projection_on_X_Y_axis: 0.5\n");
  robot.start("drive");
  const auto odometry = robot.listen<nav_msgs::Odometry>("/drive/odometry");
  robot.step(10);
  const double x = 0.3, y = 0.2, turn = 0.4;
  robot.tell("/drive/reference", twist(x, y, turn));
  robot.step(1000);
  const auto speed = [&](const char* joint) { return robot.model().joint(joint)->velocity(); };
  EXPECT_NEAR(speed("fl"), (x - y - 0.5 * turn) / 0.1, 1e-6);
  EXPECT_NEAR(speed("fr"), (x + y + 0.5 * turn) / 0.1, 1e-6);
  EXPECT_NEAR(speed("rr"), (x - y + 0.5 * turn) / 0.1, 1e-6);
  EXPECT_NEAR(speed("rl"), (x + y - 0.5 * turn) / 0.1, 1e-6);
  const auto last = robot.next(*odometry);
  // commanded after 0.01 s, and from there with a step's delay
  const double angle = turn * (last.header.stamp.sec + last.header.stamp.nanosec * 1e-9 - 0.011);
  // the integral of the rotated velocity
  EXPECT_NEAR(last.pose.pose.position.x, (x * std::sin(angle) - y * (1 - std::cos(angle))) / turn, 2e-3);
  EXPECT_NEAR(last.pose.pose.position.y, (x * (1 - std::cos(angle)) + y * std::sin(angle)) / turn, 2e-3);
  EXPECT_NEAR(last.twist.twist.linear.y, y, 1e-6);
}

TEST(TricycleController, TurnsAndDrivesItsWheel) {
  ControlledRobot robot(
      test::worldOf(spinning({"traction", "steering"})), "m",
      "controller_manager:\n  ros__parameters:\n    drive: {type: tricycle_controller/TricycleController}\n"
      "drive:\n  ros__parameters:\n    traction_joint_name: traction\n    steering_joint_name: steering\n"
      "    wheelbase: 1.7\n    wheel_radius: 0.3\n    cmd_vel_timeout: 100000\n"
      "    traction: {max_acceleration: 5.0}\n    steering: {max_velocity: 1.0}\n");
  robot.start("drive");
  const auto odometry = robot.listen<nav_msgs::Odometry>("/drive/odom");
  robot.step(10);
  robot.tell("/drive/cmd_vel", twist(1, 0, 0.2));
  robot.step(100);
  EXPECT_NEAR(robot.hardware().command("traction/velocity")->get(), 0.5, 1e-6);
  EXPECT_NEAR(robot.hardware().command("steering/position")->get(), 0.1, 1e-6);
  robot.step(2900);
  const double angle = std::atan(0.2 * 1.7);
  EXPECT_NEAR(robot.model().joint("steering")->position(), angle, 1e-3);
  EXPECT_NEAR(robot.model().joint("traction")->velocity(), 1 / (0.3 * std::cos(angle)), 1e-3);
  const auto last = robot.next(*odometry);
  EXPECT_NEAR(last.twist.twist.linear.x, 1, 1e-3);
  EXPECT_NEAR(last.twist.twist.angular.z, 0.2, 1e-3);
}

TEST(SteeringController, SteersAndDrivesAnAckermannVehicle) {
  ControlledRobot robot(
      test::worldOf(spinning({"rl", "rr", "sl", "sr"})), "m",
      "controller_manager:\n  ros__parameters:\n"
      "    car: {type: ackermann_steering_controller/AckermannSteeringController}\n"
      "car:\n  ros__parameters:\n    traction_joints_names: [rr, rl]\n    steering_joints_names: [sr, sl]\n"
      "    wheelbase: 1.7\n    traction_track_width: 1.0\n    traction_wheels_radius: 0.3\n    reference_timeout: "
      "2.0\n");
  robot.start("car");
  const auto odometry = robot.listen<nav_msgs::Odometry>("/car/odometry");
  robot.step(10);
  robot.tell("/car/reference", twist(1.2, 0, 0.3));
  robot.step(1500);
  EXPECT_NEAR(robot.model().joint("sl")->position(), std::atan(1.7 / (4 - 0.5)), 1e-3);
  EXPECT_NEAR(robot.model().joint("sr")->position(), std::atan(1.7 / (4 + 0.5)), 1e-3);
  EXPECT_NEAR(robot.model().joint("rr")->velocity(), 0.3 * 4.5 / 0.3, 1e-2);
  const auto last = robot.next(*odometry);
  EXPECT_NEAR(last.twist.twist.linear.x, 1.2, 1e-2);
  EXPECT_NEAR(last.twist.twist.angular.z, 0.3, 1e-2);
  // it stops when commands end
  robot.step(1000);
  EXPECT_NEAR(robot.model().joint("rr")->velocity(), 0, 1e-6);
  EXPECT_NEAR(robot.model().joint("sl")->position(), std::atan(1.7 / (4 - 0.5)), 1e-3);
}

}  // namespace
}  // namespace pongsim::ros2
