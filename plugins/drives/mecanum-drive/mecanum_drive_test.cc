#include <gtest/gtest.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::mecanum_drive_test {
namespace {

using test::replaced;
using test::RunningWorld;

std::string crab() { return test::modelsOf("plugins/drives/mecanum-drive/mecanum_drive.sdf"); }
std::string crabWith(const std::string& parameters) {
  return replaced(crab(), "<wheelbase>", parameters + "<wheelbase>");
}

void drive(RunningWorld& world, double x, double y, double yaw, const char* topic = "/model/crab/cmd_vel") {
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(x);
  twist.mutable_linear()->set_y(y);
  twist.mutable_angular()->set_z(yaw);
  world.tell(topic, twist);
}

Model robot(RunningWorld& world) { return world.model("crab"); }
double wheelSpeed(RunningWorld& world, const char* joint) { return robot(world).joint(joint)->velocity(); }

struct Way {
  double x, y, yaw;
};

/// @return How far it goes in two seconds, from a second after the command on.
Way wayOf(double x, double y, double yaw) {
  RunningWorld world(crab());
  drive(world, x, y, yaw);
  world.step(1000);
  const Pose before = robot(world).pose();
  world.step(2000);
  const Pose now = robot(world).pose();
  return {now.position.x() - before.position.x(), now.position.y() - before.position.y(),
          yawOf(now.rotation) - yawOf(before.rotation)};
}

TEST(MecanumDrive, DrivesForwardSidewaysAndAcrossAtTheCommandedSpeed) {
  for (const auto& [x, y] :
       std::vector<std::array<double, 2>>{{0.4, 0}, {0, 0.4}, {0, -0.4}, {0.3, 0.3}, {-0.2, 0.4}}) {
    const Way way = wayOf(x, y, 0);
    EXPECT_NEAR(way.x, 2 * x, 0.01) << x << " " << y;
    EXPECT_NEAR(way.y, 2 * y, 0.01) << x << " " << y;
    EXPECT_NEAR(way.yaw, 0, 0.01) << x << " " << y;
  }
}

TEST(MecanumDrive, TurnsInPlaceAtTheCommandedRate) {
  const Way way = wayOf(0, 0, 0.6);
  EXPECT_NEAR(way.yaw, 1.2, 0.012);
  EXPECT_NEAR(std::hypot(way.x, way.y), 0, 0.01);
}

TEST(MecanumDrive, StandsStillWithoutACommand) {
  RunningWorld world(crab());
  world.step(500);
  EXPECT_LT(robot(world).pose().position.norm(), 2e-3);
}

TEST(MecanumDrive, KeepsWithinItsLimitsInEachDirection) {
  RunningWorld world(crabWith("<max_velocity>0.3</max_velocity>"));
  drive(world, 0, 5, 0);
  world.step(100);
  // 2 m/s^2 for 0.1 s, wheels of 0.1 m
  EXPECT_NEAR(wheelSpeed(world, "front_right_joint"), 2, 0.05);
  EXPECT_NEAR(wheelSpeed(world, "front_left_joint"), -2, 0.05);
  drive(world, 5, 5, 0);
  world.step(500);
  EXPECT_NEAR(wheelSpeed(world, "front_right_joint"), 6, 0.05);
  EXPECT_NEAR(wheelSpeed(world, "front_left_joint"), 0, 0.05);
}

TEST(MecanumDrive, PublishesOdometryThatAgreesWithTheTruth) {
  RunningWorld world(crab());
  std::vector<ignition::msgs::Odometry> odometry;
  std::vector<ignition::msgs::Pose_V> tf;
  world.listen("/model/crab/odometry", odometry);
  world.listen("/model/crab/tf", tf);
  drive(world, 0.2, 0.3, 0.4);
  world.step(3000);
  ASSERT_EQ(odometry.size(), 150U);
  ASSERT_EQ(tf.size(), 150U);
  const ignition::msgs::Odometry& last = odometry.back();
  const Pose truth = robot(world).pose();
  EXPECT_NEAR(last.pose().position().x(), truth.position.x(), 0.02);
  EXPECT_NEAR(last.pose().position().y(), truth.position.y(), 0.02);
  EXPECT_NEAR(2 * std::atan2(last.pose().orientation().z(), last.pose().orientation().w()), yawOf(truth.rotation),
              0.02);
  EXPECT_NEAR(last.twist().linear().x(), 0.2, 2e-3);
  EXPECT_NEAR(last.twist().linear().y(), 0.3, 2e-3);
  EXPECT_NEAR(last.twist().angular().z(), 0.4, 2e-3);
  EXPECT_EQ(last.header().data(0).value(0), "crab/odom");
  EXPECT_EQ(last.header().data(1).value(0), "crab/base");
}

TEST(MecanumDrive, SpeaksOnTheTopicsThatTheWorldNames) {
  RunningWorld world(
      crabWith("<topic>go</topic><odom_topic>odom</odom_topic><tf_topic>frames</tf_topic><frame_id>map</frame_id>"
               "<child_frame_id>base</child_frame_id><odom_publish_frequency>10</odom_publish_frequency>"));
  std::vector<ignition::msgs::Odometry> odometry;
  std::vector<ignition::msgs::Pose_V> tf;
  world.listen("/odom", odometry);
  world.listen("/frames", tf);
  drive(world, 0.5, 0, 0, "/go");
  world.step(1000);
  EXPECT_EQ(odometry.size(), 10U);
  ASSERT_EQ(tf.size(), 10U);
  EXPECT_EQ(tf[0].pose(0).header().data(0).value(0), "map");
  EXPECT_EQ(tf[0].pose(0).header().data(1).value(0), "base");
  EXPECT_NEAR(wheelSpeed(world, "back_left_joint"), 5, 0.01);
}

TEST(MecanumDrive, IgnoresCommandsThatMakeNoSense) {
  RunningWorld world(crab());
  drive(world, 0, 0.2, 0);
  world.step(300);
  for (const double bad : {double{NAN}, std::numeric_limits<double>::infinity(), 1e308, -1e7}) {
    drive(world, bad, 0, 0);
    drive(world, 0, bad, 0);
    drive(world, 0, 0, bad);
    world.step(20);
    EXPECT_NEAR(wheelSpeed(world, "front_right_joint"), 2, 0.01);
  }
  drive(world, 0, 0, 0);
  world.step(300);
  EXPECT_NEAR(wheelSpeed(world, "front_right_joint"), 0, 0.01);
}

TEST(MecanumDrive, DoesNothingWhilePaused) {
  RunningWorld world(crab());
  std::vector<ignition::msgs::Odometry> odometry;
  world.listen("/model/crab/odometry", odometry);
  drive(world, 0.5, 0, 0);
  for (int i = 0; i < 100; ++i) world.simulation().stepPaused();
  EXPECT_TRUE(odometry.empty());
}

TEST(MecanumDrive, BeginsAnewAfterAReset) {
  RunningWorld world(crab());
  std::vector<ignition::msgs::Odometry> odometry;
  world.listen("/model/crab/odometry", odometry);
  std::vector<std::string> told;
  const auto run = [&](double y) {
    drive(world, 0.1, y, 0.2);
    world.step(300);
    told.push_back(odometry.back().SerializeAsString());
  };
  test::expectToBeginAnewAfterReset(
      world, [&] { run(0.3); }, [&] { run(-0.3); });
  EXPECT_EQ(told.front(), told.back());
}

TEST(MecanumDrive, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(crab());
  drive(world, 0.1, 0.3, 0.2);
  // while it still speeds up
  world.step(100);
  RunningWorld other(crab());
  drive(other, -0.5, 0, 0);
  other.step(30);
  test::expectSameBitsFromSavedState<ignition::msgs::Odometry>(world, other, 500, "/model/crab/odometry");
}

TEST(MecanumDriveParameters, SayWhatIsWrong) {
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"<front_left_joint>front_left_joint", "<front_left_joint>front_lift_joint",
            "<front_left_joint> 'front_lift_joint' is not a joint of model 'crab'"},
           {"<back_right_joint>back_right_joint</back_right_joint>", "", "<back_right_joint>"},
           {"<wheel_separation>0.4", "<wheel_separation>0", "<wheel_separation> must be above zero"},
           {"<wheelbase>0.5", "<wheelbase>-1", "<wheelbase> must be above zero"},
           {"<max_acceleration>2", "<max_acceleration>-4", "the minimum linear acceleration is above the maximum"}}) {
    const std::vector<std::string> complaints = RunningWorld::complaintsAbout(replaced(crab(), from, to));
    ASSERT_EQ(complaints.size(), 1U) << to;
    EXPECT_NE(complaints[0].find(message), std::string::npos) << complaints[0];
  }
}

}  // namespace
}  // namespace pongsim::mecanum_drive_test
