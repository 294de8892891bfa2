#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::tracked_vehicle_test {
namespace {

using test::replaced;
using test::RunningWorld;

// of the example
constexpr double kSeparation = 0.5, kEfficiency = 0.53;

std::string crawler() { return test::modelsOf("plugins/drives/tracked-vehicle/tracked_vehicle.sdf"); }
std::string crawlerWith(const std::string& parameters) {
  return replaced(crawler(), "<track_height>", parameters + "<track_height>");
}

void drive(RunningWorld& world, double linear, double angular, const char* topic = "/model/crawler/cmd_vel") {
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(linear);
  twist.mutable_angular()->set_z(angular);
  world.tell(topic, twist);
}

void setEfficiency(RunningWorld& world, double efficiency, const char* topic = "/model/crawler/steering_efficiency") {
  ignition::msgs::Double message;
  message.set_data(efficiency);
  world.tell(topic, message);
}

Link body(RunningWorld& world) { return world.model("crawler").link("body").value(); }
double speedOf(RunningWorld& world, const char* track) {
  return world.model("crawler").link(track)->collisions()[0].surfaceMotion()->speed;
}

TEST(TrackedVehicle, DrivesForwardAtTheCommandedSpeed) {
  RunningWorld world(crawler());
  drive(world, 0.5, 0);
  world.step(1000);
  const double before = body(world).pose().position.x();
  world.step(1000);
  EXPECT_NEAR(body(world).pose().position.x() - before, 0.5, 0.005);
  EXPECT_NEAR(body(world).pose().position.y(), 0, 0.005);
}

// The tracks touch the ground at their corners, at a distance R from the middle. Each corner's belt pushes along the
// circle about it, at v = w separation / (2 efficiency): the vehicle turns at v / R.
TEST(TrackedVehicle, TurnsOnTheSpotByTheSteeringEfficiency) {
  const double inner = std::hypot(0.4, 0.23), outer = std::hypot(0.4, 0.27);
  for (const double efficiency : {kEfficiency, 0.8}) {
    RunningWorld world(crawler());
    setEfficiency(world, efficiency);
    drive(world, 0, 0.5);
    world.step(500);
    const double before = yawOf(body(world).pose().rotation);
    world.step(2000);
    const double rate = (yawOf(body(world).pose().rotation) - before) / 2;
    const double speed = 0.5 * kSeparation / (2 * efficiency);
    EXPECT_GT(rate, 0.995 * speed / outer);
    EXPECT_LT(rate, 1.005 * speed / inner);
    EXPECT_LT(body(world).pose().position.head<2>().norm(), 0.02);
  }
}

TEST(TrackedVehicle, TellsTheTracksTheirSpeedsAndWhatTheyTurnAbout) {
  RunningWorld world(crawler());
  std::vector<ignition::msgs::Double> speeds;
  std::vector<ignition::msgs::Vector3d> centers;
  world.listen("/model/crawler/link/right/track_cmd_vel", speeds);
  world.listen("/model/crawler/link/right/track_cmd_center_of_rotation", centers);
  drive(world, 0, 0.5);
  world.step(2);
  const double turning = 0.5 * kSeparation / (2 * kEfficiency);
  EXPECT_DOUBLE_EQ(speedOf(world, "left"), -turning);
  EXPECT_DOUBLE_EQ(speedOf(world, "right"), turning);
  ASSERT_EQ(speeds.size(), 1U) << "when it changes";
  ASSERT_EQ(centers.size(), 1U);
  EXPECT_NEAR(centers[0].x(), 0, 1e-3);
  EXPECT_NEAR(centers[0].y(), 0, 1e-3);

  // along a curve, once 2 m/s^2 have brought it there
  drive(world, 0.4, 0.2);
  world.step(300);
  EXPECT_DOUBLE_EQ(speeds.back().data(), 0.4 + 0.4 * turning);
  const Vector3 center = body(world).pose() * Vector3(0, 2, 0);
  EXPECT_NEAR(centers.back().x(), center.x(), 0.1);
  EXPECT_NEAR(centers.back().y(), center.y(), 0.1);
  const std::size_t told = speeds.size();
  EXPECT_GT(told, 200U);
  EXPECT_LT(told, 220U) << "not while nothing changes";

  // straight on
  drive(world, 0.4, 0.05);
  world.step(2);
  EXPECT_EQ(centers.back().x(), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(speeds.back().data(), 0.4 + 0.1 * turning, 1e-12);
}

TEST(TrackedVehicle, FollowsACurve) {
  RunningWorld world(crawler());
  drive(world, 0.5, 0.25);
  world.step(1000);
  const double before = yawOf(body(world).pose().rotation);
  world.step(2000);
  EXPECT_NEAR(yawOf(body(world).pose().rotation) - before, 0.5, 0.15);
  EXPECT_GT(body(world).pose().position.y(), 0.2);
}

TEST(TrackedVehicle, KeepsWithinItsLimits) {
  RunningWorld world(crawlerWith("<angular_velocity><max_velocity>0.3</max_velocity></angular_velocity>"));
  drive(world, 1, 0);
  world.step(101);
  EXPECT_NEAR(speedOf(world, "left"), 0.2, 0.003);
  drive(world, 0, 2);
  world.step(600);
  EXPECT_NEAR(speedOf(world, "right"), 0.3 * kSeparation / (2 * kEfficiency), 1e-9);
}

TEST(TrackedVehicle, TakesItsTracksForWheelsInItsOdometry) {
  RunningWorld world(crawler());
  std::vector<ignition::msgs::Odometry> odometry;
  std::vector<ignition::msgs::Pose_V> tf;
  world.listen("/model/crawler/odometry", odometry);
  world.listen("/model/crawler/tf", tf);
  drive(world, 0.5, 0);
  world.step(2000);
  EXPECT_EQ(odometry.size(), 100U);
  EXPECT_EQ(tf.size(), 100U);
  EXPECT_NEAR(odometry.back().pose().position().x(), body(world).pose().position.x(), 0.02);
  EXPECT_NEAR(odometry.back().twist().linear().x(), 0.5, 1e-9);
  EXPECT_EQ(odometry.back().header().data(0).value(0), "crawler/odom");
  EXPECT_EQ(odometry.back().header().data(1).value(0), "crawler/body");
  drive(world, 0, 0.3);
  world.step(1000);
  EXPECT_NEAR(odometry.back().twist().angular().z(), 0.3 / kEfficiency, 1e-9);
}

TEST(TrackedVehicle, NamesTheBodyThatTheWorldNames) {
  RunningWorld world(crawlerWith("<body_link>left</body_link>"));
  std::vector<ignition::msgs::Odometry> odometry;
  std::vector<ignition::msgs::Vector3d> centers;
  world.listen("/model/crawler/odometry", odometry);
  world.listen("/model/crawler/link/left/track_cmd_center_of_rotation", centers);
  drive(world, 0, 0.5);
  world.step(30);
  EXPECT_EQ(odometry.back().header().data(1).value(0), "crawler/left");
  EXPECT_NEAR(centers.at(0).y(), 0.25, 1e-3);
}

TEST(TrackedVehicle, SpeaksOnTheTopicsThatTheWorldNames) {
  std::string text = crawlerWith(
      "<topic>go</topic><steering_efficiency_topic>eff</steering_efficiency_topic><odom_topic>odom</odom_topic>"
      "<tf_topic>tf</tf_topic><frame_id>map</frame_id><child_frame_id>base</child_frame_id>"
      "<odom_publish_frequency>10</odom_publish_frequency>");
  text = replaced(text, "<left_track><link>left</link>",
                  "<left_track><link>left</link><velocity_topic>left_speed</velocity_topic>"
                  "<center_of_rotation_topic>left_center</center_of_rotation_topic>");
  RunningWorld world(text);
  std::vector<ignition::msgs::Double> speeds;
  std::vector<ignition::msgs::Vector3d> centers;
  std::vector<ignition::msgs::Odometry> odometry;
  world.listen("/left_speed", speeds);
  world.listen("/left_center", centers);
  world.listen("/odom", odometry);
  setEfficiency(world, 0.25, "/eff");
  drive(world, 0, 0.5, "/go");
  world.step(1000);
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_EQ(speeds[0].data(), -0.5);
  EXPECT_EQ(centers.size(), 1U);
  EXPECT_EQ(odometry.size(), 10U);
  EXPECT_EQ(odometry[0].header().data(0).value(0), "map");
  EXPECT_EQ(odometry[0].header().data(1).value(0), "base");
}

TEST(TrackedVehicle, IgnoresCommandsThatMakeNoSense) {
  RunningWorld world(crawler());
  drive(world, 0, 0.4);
  world.step(100);
  const double speed = speedOf(world, "right");
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double bad : {double{NAN}, kInfinite, 1e308, -1e7}) {
    drive(world, bad, 0);
    drive(world, 0, bad);
    world.step(2);
    EXPECT_EQ(speedOf(world, "right"), speed) << bad;
  }
  for (const double bad : {double{NAN}, kInfinite, 0.0, -0.5, 1e-310}) {
    setEfficiency(world, bad);
    world.step(2);
    EXPECT_EQ(speedOf(world, "right"), speed) << bad;
  }
  drive(world, 0, 0);
  world.step(100);
  EXPECT_EQ(speedOf(world, "right"), 0);
}

TEST(TrackedVehicle, BeginsAnewAfterAReset) {
  RunningWorld world(crawler());
  const auto run = [&world](double linear, double angular) {
    drive(world, linear, angular);
    world.step(300);
  };
  test::expectToBeginAnewAfterReset(
      world, [&] { run(0.5, 0.5); },
      [&] {
        setEfficiency(world, 0.7);
        run(-0.5, 0);
      });
}

TEST(TrackedVehicle, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(crawler());
  setEfficiency(world, 0.7);
  drive(world, 0.5, 0.5);
  world.step(100);
  RunningWorld other(crawler());
  drive(other, -0.5, 0);
  other.step(30);
  test::expectSameBitsFromSavedState<ignition::msgs::Odometry>(world, other, 500, "/model/crawler/odometry");
}

TEST(TrackedVehicleParameters, SayWhatIsWrong) {
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"<left_track><link>left", "<left_track><link>lift", "<link> 'lift' is not a link of model 'crawler'"},
           {"<left_track><link>left</link></left_track>", "", "<left_track>"},
           {"<tracks_separation>0.5", "<tracks_separation>0", "<tracks_separation> must be"},
           {"<steering_efficiency>0.53", "<steering_efficiency>0", "<steering_efficiency> must be"},
           {"<max_acceleration>2", "<max_acceleration>-3", "the minimum linear acceleration is above the maximum"},
           {"<track_height>", "<body_link>trunk</body_link><track_height>", "<body_link> 'trunk' is not a link"},
           {"<left_track><link>left", "<left_track><link>lift</link></left_track><left_track><link>left",
            "a <left_track> is left out: <link> 'lift' is not a link"}}) {
    const std::vector<std::string> complaints = RunningWorld::complaintsAbout(replaced(crawler(), from, to));
    ASSERT_EQ(complaints.size(), 1U) << to;
    EXPECT_NE(complaints[0].find(message), std::string::npos) << complaints[0];
  }
}

}  // namespace
}  // namespace pongsim::tracked_vehicle_test
