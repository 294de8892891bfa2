#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/vector3d.pb.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::track_controller_test {
namespace {

using test::replaced;
using test::RunningWorld;

constexpr const char* kSpeedTopic = "/model/conveyor/link/belt/track_cmd_vel";
constexpr const char* kCenterTopic = "/model/conveyor/link/belt/track_cmd_center_of_rotation";

std::string conveyor() { return test::modelsOf("plugins/drives/track-controller/track_controller.sdf"); }
std::string conveyorWith(const std::string& parameters) {
  return replaced(conveyor(), "<link>belt</link>", "<link>belt</link>" + parameters);
}

void tellSpeed(RunningWorld& world, double speed, const char* topic = kSpeedTopic) {
  ignition::msgs::Double message;
  message.set_data(speed);
  world.tell(topic, message);
}

void tellCenter(RunningWorld& world, double x, double y, double z) {
  ignition::msgs::Vector3d message;
  message.set_x(x);
  message.set_y(y);
  message.set_z(z);
  world.tell(kCenterTopic, message);
}

Link crate(RunningWorld& world) { return world.model("crate").link("link").value(); }
SurfaceMotion beltOf(RunningWorld& world) {
  return world.model("conveyor").link("belt")->collisions()[0].surfaceMotion().value();
}

TEST(TrackController, StandsStillWithoutACommand) {
  RunningWorld world(conveyor());
  world.step(1000);
  EXPECT_LT(crate(world).linearVelocity().norm(), 1e-5);
  EXPECT_EQ(beltOf(world).speed, 0);
}

TEST(TrackController, CarriesWhatLiesOnItAtTheCommandedSpeed) {
  for (const double speed : {0.5, -0.3}) {
    RunningWorld world(conveyor());
    tellSpeed(world, speed);
    world.step(1000);
    EXPECT_NEAR(crate(world).linearVelocity().x(), speed, 0.01 * std::abs(speed));
    const double before = crate(world).pose().position.x();
    world.step(1000);
    EXPECT_NEAR(crate(world).pose().position.x() - before, speed, 0.01 * std::abs(speed));
  }
}

TEST(TrackController, KeepsWithinItsLimits) {
  RunningWorld world(conveyorWith("<max_velocity>0.4</max_velocity><max_jerk>20</max_jerk>"));
  tellSpeed(world, 3);
  world.step(50);
  // 20 m/s^3 for 50 ms, and 1 m/s^2 from then on
  EXPECT_NEAR(beltOf(world).speed, 0.025, 0.001);
  world.step(150);
  EXPECT_NEAR(beltOf(world).speed, 0.175, 0.002);
  world.step(400);
  EXPECT_EQ(beltOf(world).speed, 0.4);
}

TEST(TrackController, TellsHowFarTheTrackHasRun) {
  for (const auto& [parameters, topic, rate] : std::vector<std::tuple<std::string, std::string, double>>{
           {"", "/model/conveyor/link/belt/odometry", 50},
           {"<odometry_topic>way</odometry_topic><odometry_publish_frequency>10</odometry_publish_frequency>", "/way",
            10}}) {
    RunningWorld world(conveyorWith(parameters));
    std::vector<ignition::msgs::Odometry> messages;
    world.listen(topic, messages);
    tellSpeed(world, 0.5);
    world.step(1000);
    ASSERT_EQ(messages.size(), rate);
    // it speeds up by 1 m/s^2 for half a second
    EXPECT_NEAR(messages.back().pose().position().x(), 0.125 + 0.25, 1e-3);
    EXPECT_EQ(messages.back().twist().linear().x(), 0.5);
    EXPECT_EQ(messages.back().header().stamp().sec(), 1);
  }
}

TEST(TrackController, StopsWhereNoCommandHasComeForSoLong) {
  RunningWorld world(conveyorWith("<max_command_age>0.5</max_command_age>"));
  tellSpeed(world, 0.2);
  world.step(501);
  EXPECT_EQ(beltOf(world).speed, 0.2);
  world.step(100);
  // within its limits
  EXPECT_NEAR(beltOf(world).speed, 0.1, 0.002);
  world.step(200);
  EXPECT_EQ(beltOf(world).speed, 0);
  tellSpeed(world, 0.2);
  world.step(300);
  EXPECT_EQ(beltOf(world).speed, 0.2);
}

TEST(TrackController, RunsTheWayThatTheTrackLies) {
  RunningWorld world(conveyorWith("<track_orientation>0 0 1.5707963267948966</track_orientation>"));
  tellSpeed(world, 0.2);
  world.step(600);
  EXPECT_NEAR(crate(world).linearVelocity().y(), 0.2, 2e-3);
  EXPECT_NEAR(crate(world).linearVelocity().x(), 0, 1e-5);
}

TEST(TrackController, RunsRoundACentreUntilItIsToldThatThereIsNone) {
  RunningWorld world(conveyor());
  tellSpeed(world, 0.3);
  tellCenter(world, -1, 5, 0);
  world.step(500);
  ASSERT_TRUE(beltOf(world).center);
  EXPECT_EQ(*beltOf(world).center, Vector3(-1, 5, 0));
  EXPECT_GT(crate(world).angularVelocity().z(), 0.9 * 0.3 / 5.2);
  EXPECT_LT(crate(world).angularVelocity().z(), 1.1 * 0.3 / 4.8);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  for (const double none : {kNone, double{NAN}, 1e308}) {
    tellCenter(world, 0, 5, 0);
    world.step(1);
    EXPECT_TRUE(beltOf(world).center);
    tellCenter(world, none, 0, 0);
    world.step(1);
    EXPECT_FALSE(beltOf(world).center) << none;
  }
  world.step(200);
  EXPECT_NEAR(crate(world).angularVelocity().z(), 0, 1e-4);
}

TEST(TrackController, IgnoresSpeedsThatMakeNoSense) {
  RunningWorld world(conveyor());
  tellSpeed(world, 0.2);
  world.step(300);
  for (const double bad : {double{NAN}, -std::numeric_limits<double>::infinity(), 1e308, -1e7}) {
    tellSpeed(world, bad);
    world.step(1);
    EXPECT_EQ(beltOf(world).speed, 0.2);
  }
  tellSpeed(world, 0.1);
  world.step(300);
  EXPECT_NEAR(crate(world).linearVelocity().x(), 0.1, 1e-3);
}

TEST(TrackController, ListensToTheTopicsThatTheWorldNames) {
  RunningWorld world(conveyorWith(
      "<velocity_topic>speed</velocity_topic><center_of_rotation_topic>/center</center_of_rotation_topic>"));
  tellSpeed(world, 0.2, "/speed");
  ignition::msgs::Vector3d center;
  center.set_y(3);
  world.tell("/center", center);
  world.step(300);
  EXPECT_EQ(beltOf(world).speed, 0.2);
  EXPECT_EQ(beltOf(world).center, Vector3(0, 3, 0));
}

TEST(TrackController, DoesNothingWhilePaused) {
  RunningWorld world(conveyor());
  tellSpeed(world, 0.2);
  for (int i = 0; i < 10; ++i) world.simulation().stepPaused();
  EXPECT_FALSE(world.model("conveyor").link("belt")->collisions()[0].surfaceMotion());
}

TEST(TrackController, BeginsAnewAfterAReset) {
  RunningWorld world(conveyorWith("<max_command_age>1</max_command_age>"));
  world.step(400);
  const std::uint64_t untold = world.simulation().stateHash();
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  tellSpeed(world, 0.4);
  tellCenter(world, 0, 2, 0);
  world.step(400);
  EXPECT_NE(world.simulation().stateHash(), untold);
  world.simulation().reset(diagnostics);
  world.step(400);
  EXPECT_EQ(world.simulation().stateHash(), untold);
}

TEST(TrackController, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(conveyorWith("<max_command_age>0.5</max_command_age>"));
  tellSpeed(world, 0.4);
  tellCenter(world, 0, 2, 0);
  world.step(200);
  RunningWorld other(conveyorWith("<max_command_age>0.5</max_command_age>"));
  tellSpeed(other, -0.2);
  other.step(30);
  // through the end of the command's age
  test::expectSameBitsFromSavedState(world, other, 600);
}

TEST(TrackControllerParameters, SayWhatIsWrong) {
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"<link>belt", "<link>bell", "<link> 'bell' is not a link of model 'conveyor'"},
           {"<link>belt</link>", "", "<link>"},
           {"<max_acceleration>1", "<max_acceleration>-3", "the minimum track acceleration is above the maximum"},
           {"<link>belt</link>", "<link>belt</link><max_command_age>-1</max_command_age>", "<max_command_age>"},
           {"<link>belt</link>", "<link>belt</link><track_orientation>0 0</track_orientation>",
            "<track_orientation>"}}) {
    const std::vector<std::string> complaints = RunningWorld::complaintsAbout(replaced(conveyor(), from, to));
    ASSERT_EQ(complaints.size(), 1U) << to;
    EXPECT_NE(complaints[0].find(message), std::string::npos) << complaints[0];
  }
}

TEST(TrackControllerParameters, WarnOfATrackThatTouchesNothing) {
  std::string world = conveyor();
  const std::size_t begin = world.find("<collision"), end = world.find("</collision>");
  world.erase(begin, end + 12 - begin);
  const std::vector<std::string> complaints = RunningWorld::complaintsAbout(world);
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_NE(complaints[0].find("'belt' has no <collision>"), std::string::npos) << complaints[0];
}

}  // namespace
}  // namespace pongsim::track_controller_test
