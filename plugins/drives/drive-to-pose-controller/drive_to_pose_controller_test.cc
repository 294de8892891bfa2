#include <gtest/gtest.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::drive_to_pose_controller_test {
namespace {

using test::RunningWorld;

std::string rover() { return test::modelsOf("plugins/drives/drive-to-pose-controller/drive_to_pose_controller.sdf"); }

/// A model without wheels: what it is told is only published.
std::string controllerWith(const std::string& parameters) {
  return "<model name='m'><static>true</static><link name='l'/><plugin "
         "filename='gz-sim-drive-to-pose-controller-system' name='gz::sim::systems::DriveToPoseController'>" +
         parameters + "</plugin></model>";
}

ignition::msgs::Pose_V poses(double x, double y, double heading) {
  ignition::msgs::Pose_V message;
  ignition::msgs::Pose& pose = *message.add_pose();
  pose.mutable_position()->set_x(x);
  pose.mutable_position()->set_y(y);
  pose.mutable_orientation()->set_w(std::cos(heading / 2));
  pose.mutable_orientation()->set_z(std::sin(heading / 2));
  return message;
}

// the goals of Gazebo's own test
TEST(DriveToPoseController, DrivesToWhereItIsTold) {
  const std::vector<std::array<double, 3>> goals{{0, 0, 0}, {1.5, 0, 0}, {0, 1.5, 0}, {0, 0, -1.57}, {1.5, -1.5, 1.57}};
  for (const auto& [x, y, heading] : goals) {
    RunningWorld world(rover());
    std::vector<ignition::msgs::Pose> reached;
    std::vector<ignition::msgs::Twist> commands;
    world.listen("/model/rover/reached_pose", reached);
    world.listen("/model/rover/cmd_vel", commands);
    world.tell("/model/rover/cmd_pose", poses(x, y, heading));
    for (int i = 0; i < 20 && reached.empty(); ++i) world.step(1000);
    ASSERT_EQ(reached.size(), 1U) << x << ' ' << y << ' ' << heading;
    EXPECT_NEAR(reached[0].position().x(), x, 0.1);
    EXPECT_NEAR(reached[0].position().y(), y, 0.1);
    EXPECT_EQ(commands.back().linear().x(), 0);
    EXPECT_EQ(commands.back().angular().z(), 0);
    world.step(1000);
    const Pose pose = world.model("rover").pose();
    EXPECT_NEAR(pose.position.x(), x, 0.12);
    EXPECT_NEAR(pose.position.y(), y, 0.12);
    EXPECT_NEAR(yawOf(pose.rotation), heading, 0.07);
    // it says so once
    EXPECT_EQ(reached.size(), 1U);
  }
}

TEST(DriveToPoseController, TurnsThenDrivesThenTurns) {
  RunningWorld world(
      controllerWith("<linear_p_gain>3</linear_p_gain><angular_p_gain>4</angular_p_gain>"
                     "<linear_deviation>0.5</linear_deviation><angular_deviation>0.1</angular_deviation>"));
  std::vector<ignition::msgs::Twist> commands;
  world.listen("/model/m/cmd_vel", commands);
  world.tell("/model/m/cmd_pose", poses(2, 2, 3));
  const auto command = [&](double x, double y, double heading) {
    commands.clear();
    world.tell("/model/m/pose", poses(x, y, heading));
    world.step(1);
    EXPECT_EQ(commands.size(), 1U);
    return commands.empty() ? std::array{std::nan(""), std::nan("")}
                            : std::array{commands[0].linear().x(), commands[0].angular().z()};
  };
  const double quarter = std::acos(-1.0) / 4;
  // towards it, the shorter way round
  EXPECT_NEAR(command(0, 0, 0)[1], 4 * quarter, 1e-9);
  EXPECT_EQ(command(0, 0, 0)[0], 0);
  EXPECT_NEAR(command(0, 0, -3)[1], 4 * (quarter + 3 - 8 * quarter), 1e-9);
  EXPECT_NEAR(command(0, 0, quarter + 0.05)[0], 3 * std::sqrt(8), 1e-9);
  EXPECT_EQ(command(0, 0, quarter + 0.05)[1], 0);
  // there, and only its heading is wrong
  EXPECT_NEAR(command(2, 1.6, 1)[1], 4 * 2, 1e-9);
  EXPECT_EQ(command(2, 1.6, 1)[0], 0);
  EXPECT_EQ(command(2, 1.6, 2.95)[1], 0);
  world.step(10);
  // it is reached: no more commands
  EXPECT_EQ(commands.size(), 1U);
}

TEST(DriveToPoseController, SaysNothingWithoutAPoseOrAGoal) {
  RunningWorld world(controllerWith(""));
  std::vector<ignition::msgs::Twist> commands;
  world.listen("/model/m/cmd_vel", commands);
  world.tell("/model/m/pose", poses(0, 0, 0));
  world.step(10);
  RunningWorld other(controllerWith(""));
  other.listen("/model/m/cmd_vel", commands);
  other.tell("/model/m/cmd_pose", poses(1, 0, 0));
  other.step(10);
  EXPECT_TRUE(commands.empty());
}

TEST(DriveToPoseController, GoesOnAfterGoalsThatMakeNoSense) {
  RunningWorld world(rover());
  world.tellAbsurdities("/model/rover/cmd_pose", "ignition.msgs.Pose_V", "pose {position {x: #}}");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) world.tellText("/model/rover/cmd_pose", "ignition.msgs.Pose_V", "");
  world.step(10);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("a message without a pose on /cmd_pose was ignored"), std::string::npos) << said;
  EXPECT_EQ(said.find("ignored"), said.rfind("ignored"));
  // the largest, and one without an orientation
  world.tell("/model/rover/cmd_pose", poses(1e6, -1e6, 0));
  world.step(1000);
  world.tellText("/model/rover/cmd_pose", "ignition.msgs.Pose_V", "pose {position {x: 0.5}}");
  std::vector<ignition::msgs::Pose> reached;
  world.listen("/model/rover/reached_pose", reached);
  for (int i = 0; i < 30 && reached.empty(); ++i) world.step(1000);
  ASSERT_EQ(reached.size(), 1U);
  EXPECT_NEAR(yawOf(world.model("rover").pose().rotation), 0, 0.07);
}

TEST(DriveToPoseController, GoesOnWithTheSameBitsFromASavedStateAndForgetsItsGoalInAReset) {
  RunningWorld world(rover());
  world.tell("/model/rover/cmd_pose", poses(1, 1, 0));
  world.step(500);
  RunningWorld other(rover());
  test::expectSameBitsFromSavedState(world, other, 500);
  test::resetWorld(other);
  other.step(500);
  EXPECT_NEAR(other.model("rover").pose().position.x(), 0, 1e-3);
}

TEST(DriveToPoseController, IsLeftOutWithTheReason) {
  EXPECT_EQ(
      RunningWorld::complaintsAbout(controllerWith("<linear_deviation>-1</linear_deviation>")),
      std::vector<std::string>{"drive-to-pose-controller of m is left out: <linear_deviation> must be zero or more"});
}

}  // namespace
}  // namespace pongsim::drive_to_pose_controller_test
