#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::diff_drive_test {
namespace {

std::string exampleWorld() {
  std::ifstream file(test::projectFolder() / "plugins/drives/diff-drive/diff_drive.sdf");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// @return `text` with the first `from` replaced by `to`; a test fails if it is not there.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  if (position != std::string::npos) text.replace(position, from.size(), to);
  return text;
}

/// @return What is wrong with a world, formatted.
std::vector<std::string> errorsOf(const std::string& world) {
  Diagnostics diagnostics;
  Simulation::fromText(world, "world.sdf", {}, diagnostics);
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : diagnostics.all()) lines.push_back(format(diagnostic));
  return lines;
}

class DiffDriveTest : public testing::Test {
 protected:
  void start(const std::string& world = exampleWorld(), const std::string& commandTopic = "/model/rover/cmd_vel") {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(world, "world.sdf", {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    ASSERT_NE(simulation_, nullptr);
    Node node = simulation_->transport().node();
    command_ = node.advertise<ignition::msgs::Twist>(commandTopic);
    enable_ = node.advertise<ignition::msgs::Boolean>("/model/rover/enable");
    odometry_ = node.subscribe<ignition::msgs::Odometry>(
        "/model/rover/odometry", [this](const auto& message) { odometries_.push_back(message); });
    tf_ = node.subscribe<ignition::msgs::Pose_V>("/model/rover/tf",
                                                 [this](const auto& message) { tfs_.push_back(message); });
  }

  void drive(double linear, double angular) {
    ignition::msgs::Twist twist;
    twist.mutable_linear()->set_x(linear);
    twist.mutable_angular()->set_z(angular);
    command_.publish(twist);
  }

  void setEnabled(bool enabled) {
    ignition::msgs::Boolean message;
    message.set_data(enabled);
    enable_.publish(message);
  }

  Model rover() { return simulation_->world().model("rover").value(); }
  double wheelSpeed(const char* joint) { return rover().joint(joint)->velocity(); }

  std::unique_ptr<Simulation> simulation_;
  Publisher command_;
  Publisher enable_;
  Subscription odometry_;
  Subscription tf_;
  std::vector<ignition::msgs::Odometry> odometries_;
  std::vector<ignition::msgs::Pose_V> tfs_;
};

TEST_F(DiffDriveTest, StandsStillWithoutACommand) {
  start();
  simulation_->step(500);
  EXPECT_NEAR(rover().pose().position.norm(), 0, 2e-3);
}

TEST_F(DiffDriveTest, DrivesForwardAtTheCommandedSpeed) {
  start();
  drive(0.5, 0);
  simulation_->step(1000);
  const double before = rover().pose().position.x();
  simulation_->step(1000);
  EXPECT_NEAR(rover().pose().position.x() - before, 0.5, 0.01);
  EXPECT_NEAR(rover().pose().position.y(), 0, 0.01);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 5, 1e-3);
}

TEST_F(DiffDriveTest, TurnsInPlaceWhenOnlyAngularIsCommanded) {
  start();
  drive(0, 1);
  simulation_->step(1000);
  EXPECT_NEAR(yawOf(rover().pose().rotation), 1, 0.05);
  EXPECT_NEAR(rover().pose().position.head<2>().norm(), 0, 0.02);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), -2, 1e-3);
  EXPECT_NEAR(wheelSpeed("right_wheel_joint"), 2, 1e-3);
}

TEST_F(DiffDriveTest, KeepsWithinItsLimits) {
  start();
  drive(5, 0);
  simulation_->step(100);
  // 2 m/s^2 for 0.1 s, wheels of 0.1 m.
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 2, 0.05);
  simulation_->step(1000);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 10, 1e-2);
}

TEST_F(DiffDriveTest, StopsAndIgnoresCommandsWhileDisabled) {
  start();
  drive(0.5, 0);
  simulation_->step(500);
  setEnabled(false);
  simulation_->step(1000);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 0, 1e-3);
  drive(0.5, 0);
  simulation_->step(500);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 0, 1e-3);
  setEnabled(true);
  drive(0.5, 0);
  simulation_->step(500);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 5, 1e-3);
}

TEST_F(DiffDriveTest, PublishesOdometryThatAgreesWithTheTruth) {
  start();
  drive(0.5, 0.3);
  simulation_->step(3001);
  // 50 Hz of simulated time; messages are handed over a step later.
  ASSERT_EQ(odometries_.size(), 150U);
  const ignition::msgs::Odometry& last = odometries_.back();
  EXPECT_EQ(last.header().stamp().sec(), 3);
  EXPECT_EQ(last.header().stamp().nsec(), 0);
  EXPECT_NEAR(last.pose().position().x(), rover().pose().position.x(), 0.03);
  EXPECT_NEAR(last.pose().position().y(), rover().pose().position.y(), 0.03);
  EXPECT_NEAR(2 * std::atan2(last.pose().orientation().z(), last.pose().orientation().w()),
              yawOf(rover().pose().rotation), 0.03);
  EXPECT_NEAR(last.twist().linear().x(), 0.5, 1e-3);
  EXPECT_NEAR(last.twist().angular().z(), 0.3, 1e-3);
}

TEST_F(DiffDriveTest, NamesItsFramesAsFortressDoes) {
  start();
  simulation_->step(100);
  ASSERT_FALSE(odometries_.empty());
  ASSERT_FALSE(tfs_.empty());
  ASSERT_EQ(tfs_.front().pose_size(), 1);
  for (const ignition::msgs::Header& header : {odometries_.front().header(), tfs_.front().pose(0).header()}) {
    ASSERT_EQ(header.data_size(), 2);
    EXPECT_EQ(header.data(0).key(), "frame_id");
    EXPECT_EQ(header.data(0).value(0), "rover/odom");
    EXPECT_EQ(header.data(1).key(), "child_frame_id");
    EXPECT_EQ(header.data(1).value(0), "rover/body");
  }
  EXPECT_FALSE(tfs_.front().has_header());
}

TEST_F(DiffDriveTest, ListensToTheTopicThatTheWorldNames) {
  start(replaced(exampleWorld(), "<wheel_radius>", "<topic>cmd_vel</topic><wheel_radius>"), "/cmd_vel");
  drive(0.5, 0);
  simulation_->step(1000);
  EXPECT_NEAR(wheelSpeed("right_wheel_joint"), 5, 1e-3);
}

TEST_F(DiffDriveTest, TurnsAllPairsOfWheels) {
  // the casters become a second pair of wheels
  std::string world = exampleWorld();
  for (const char* caster : {"front_caster_joint", "rear_caster_joint"}) {
    const std::string ball = std::string("<joint name=\"") + caster + "\" type=\"ball\">";
    world = replaced(world, ball,
                     std::string("<joint name=\"") + caster +
                         "\" type=\"revolute\"><axis><xyz expressed_in='__model__'>0 1 0</xyz></axis>");
  }
  start(replaced(world, "<wheel_separation>",
                 "<left_joint>front_caster_joint</left_joint><right_joint>rear_caster_joint</right_joint>"
                 "<wheel_separation>"));
  drive(0, 1);
  simulation_->step(500);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), -2, 0.01);
  EXPECT_NEAR(wheelSpeed("front_caster_joint"), -2, 0.01);
  EXPECT_NEAR(wheelSpeed("rear_caster_joint"), 2, 0.01);
}

TEST_F(DiffDriveTest, LimitsJerk) {
  start(replaced(exampleWorld(), "<max_linear_acceleration>2</max_linear_acceleration>",
                 "<max_linear_jerk>4</max_linear_jerk>"));
  drive(1, 0);
  simulation_->step(500);
  // 4 m/s^3 for half a second, wheels of 0.1 m
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), 5, 0.1);
}

TEST_F(DiffDriveTest, LimitsBothMotionsByTheCommonNames) {
  start(replaced(exampleWorld(), "<max_linear_velocity>1</max_linear_velocity>", "<max_velocity>0.3</max_velocity>"));
  drive(1, 1);
  simulation_->step(1000);
  EXPECT_NEAR(wheelSpeed("left_wheel_joint"), (0.3 - 0.3 * 0.2) / 0.1, 0.01);
  EXPECT_NEAR(wheelSpeed("right_wheel_joint"), (0.3 + 0.3 * 0.2) / 0.1, 0.01);
}

TEST_F(DiffDriveTest, SpeaksOnTheTopicsAndOfTheFramesThatTheWorldNames) {
  start(replaced(
      exampleWorld(), "<wheel_radius>",
      "<odom_topic>my odom</odom_topic><tf_topic>my_tf</tf_topic><frame_id>map</frame_id>"
      "<child_frame_id>base</child_frame_id><odom_publish_frequency>0</odom_publish_frequency><wheel_radius>"));
  Node node = simulation_->transport().node();
  odometry_ = node.subscribe<ignition::msgs::Odometry>("/my_odom",
                                                       [this](const auto& message) { odometries_.push_back(message); });
  tf_ = node.subscribe<ignition::msgs::Pose_V>("/my_tf", [this](const auto& message) { tfs_.push_back(message); });
  simulation_->step(101);
  ASSERT_EQ(odometries_.size(), 100U);
  ASSERT_EQ(tfs_.size(), 100U);
  EXPECT_EQ(odometries_[0].header().data(0).value(0), "map");
  EXPECT_EQ(tfs_[0].pose(0).header().data(1).value(0), "base");
  EXPECT_FALSE(odometries_[0].pose().has_header());
}

TEST_F(DiffDriveTest, DoesNothingWhilePaused) {
  start();
  drive(0.5, 0);
  for (int i = 0; i < 100; ++i) simulation_->stepPaused();
  EXPECT_TRUE(odometries_.empty());
  EXPECT_EQ(wheelSpeed("left_wheel_joint"), 0);
}

/// The example, with a robot that goes as fast as it is told.
test::RunningWorld unlimitedRover(const test::TempFolder& folder) {
  std::string world = replaced(exampleWorld(), "<max_linear_velocity>1</max_linear_velocity>", "");
  world = replaced(world, "<max_linear_acceleration>2</max_linear_acceleration>", "");
  return test::RunningWorld(folder.write("rover.sdf", world));
}

TEST(DiffDrive, RefusesAbsurdCommandsAndGoesOn) {
  for (const char* text : {"linear {x: #}", "linear {x: 1} angular {z: #}"}) {
    const test::TempFolder folder;
    test::RunningWorld world = unlimitedRover(folder);
    world.tellAbsurdities("/model/rover/cmd_vel", "ignition.msgs.Twist", text);
    EXPECT_NEAR(world.model("rover").joint("left_wheel_joint")->velocity(), 0, 1e-3);
    world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", "linear {x: 0.5}");
    world.step(1000);
    EXPECT_NEAR(world.model("rover").joint("left_wheel_joint")->velocity(), 5, 1e-3);
  }
}

TEST(DiffDrive, RecoversFromTheLargestCommands) {
  for (const char* text : {"linear {x: 1e6}", "linear {x: -1e6} angular {z: 1e6}"}) {
    const test::TempFolder folder;
    test::RunningWorld world = unlimitedRover(folder);
    testing::internal::CaptureStderr();
    world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", text);
    world.step(100);
    world.tellText("/model/rover/cmd_vel", "ignition.msgs.Twist", "linear {x: 0.5}");
    world.step(4000);
    // the physics may well say that it turns too fast
    EXPECT_EQ(testing::internal::GetCapturedStderr().find("switched off"), std::string::npos) << text;
    EXPECT_TRUE(world.model("rover").pose().position.allFinite()) << text;
    EXPECT_NEAR(world.model("rover").joint("left_wheel_joint")->velocity(), 5, 0.1) << text;
  }
}

TEST(DiffDriveParameters, NamesTheLineOfAnUnknownJoint) {
  const std::string world = replaced(exampleWorld(), "<left_joint>left_wheel_joint", "<left_joint>left_weel_joint");
  const std::vector<std::string> errors = errorsOf(world);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(
      errors[0].find(
          ": warning: diff-drive of rover is left out: <left_joint> 'left_weel_joint' is not a joint of model 'rover'"),
      std::string::npos)
      << errors[0];
  EXPECT_NE(errors[0].find("left_wheel_joint, right_wheel_joint"), std::string::npos) << errors[0];
}

TEST(DiffDriveParameters, RefusesAJointThatCannotBeDriven) {
  const std::vector<std::string> errors =
      errorsOf(replaced(exampleWorld(), "<left_joint>left_wheel_joint", "<left_joint>front_caster_joint"));
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("is a joint without an axis to drive"), std::string::npos) << errors[0];
}

TEST(DiffDriveParameters, RefusesSizesAndLimitsThatMakeNoSense) {
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"<wheel_radius>0.1", "<wheel_radius>-0.1", "<wheel_radius> must be above zero"},
           {"<wheel_separation>0.4", "<wheel_separation>wide", "<wheel_separation> is 'wide', which is not a number"},
           {"<max_linear_velocity>1", "<min_linear_velocity>2</min_linear_velocity><max_linear_velocity>1",
            "the minimum linear velocity is above the maximum"}}) {
    const std::vector<std::string> errors = errorsOf(replaced(exampleWorld(), from, to));
    ASSERT_EQ(errors.size(), 1U) << to;
    EXPECT_NE(errors[0].find(message), std::string::npos) << errors[0];
  }
}

}  // namespace
}  // namespace pongsim::diff_drive_test
