#include <gtest/gtest.h>
#include <ignition/msgs/navsat.pb.h>

#include <numbers>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::navsat_test {
namespace {

using test::RunningWorld;

constexpr const char* kEarth =
    "<spherical_coordinates><latitude_deg>10</latitude_deg><longitude_deg>20</longitude_deg><elevation>300</elevation>"
    "</spherical_coordinates>";
constexpr const char* kTopic = "/world/w/model/m/link/l/sensor/s/navsat";

std::string worldWith(const std::string& place, const std::string& pose, const std::string& sensor = "") {
  return "<gravity>0 0 0</gravity>" + place +
         R"(<plugin filename="ignition-gazebo-navsat-system" name="ignition::gazebo::systems::NavSat"/>
    <model name="m"><pose>)" +
         pose + R"(</pose><link name="l"><inertial><mass>1</mass></inertial><sensor name="s" type="navsat">)" + sensor +
         R"(</sensor></link><plugin filename="ignition-gazebo-velocity-control-system"
        name="ignition::gazebo::systems::VelocityControl"><initial_linear>1 2 3</initial_linear></plugin></model>)";
}

ignition::msgs::NavSat lastOf(RunningWorld& world) {
  std::vector<ignition::msgs::NavSat> messages;
  world.listen(kTopic, messages);
  world.step(10);
  EXPECT_EQ(messages.size(), 10U);
  return messages.at(9);
}

TEST(NavSat, TellsPlaceAndVelocity) {
  RunningWorld world(worldWith(kEarth, "0 1106.47 5 0 0 0"));
  const ignition::msgs::NavSat message = lastOf(world);
  // a degree of the meridian is 110.649 km long at 10.5 degrees
  EXPECT_NEAR(message.latitude_deg(), 10.01, 2e-5);
  EXPECT_NEAR(message.longitude_deg(), 20, 1e-5);
  EXPECT_NEAR(message.altitude(), 305.12, 0.05);
  EXPECT_NEAR(message.velocity_east(), 1, 1e-9);
  EXPECT_NEAR(message.velocity_north(), 2, 1e-9);
  EXPECT_NEAR(message.velocity_up(), 3, 1e-9);
  EXPECT_EQ(message.frame_id(), "m::l::s");
}

TEST(NavSat, AddsTheNoiseThatTheFileAsksFor) {
  const auto noise = [](const char* mean) {
    return std::string("<noise type='gaussian'><mean>") + mean + "</mean><stddev>0</stddev></noise>";
  };
  RunningWorld world(worldWith(kEarth, "0 0 0 0 0 0",
                               "<navsat><position_sensing><horizontal>" + noise("2") + "</horizontal><vertical>" +
                                   noise("7") + "</vertical></position_sensing><velocity_sensing><horizontal>" +
                                   noise("0.5") + "</horizontal></velocity_sensing></navsat>"));
  const ignition::msgs::NavSat message = lastOf(world);
  EXPECT_NEAR(message.latitude_deg(), 12, 1e-5);
  EXPECT_NEAR(message.longitude_deg(), 22, 1e-5);
  EXPECT_NEAR(message.altitude(), 307, 0.1);
  EXPECT_NEAR(message.velocity_north(), 2.5, 1e-9);
  EXPECT_NEAR(message.velocity_up(), 3, 1e-9);
}

TEST(NavSat, IsLeftOutWhereTheWorldIsNowhere) {
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("", "0 0 0 0 0 0")),
            std::vector<std::string>{"sensor 'm::l::s' can't measure its position: it is left out"});
}

TEST(NavSat, OfFortressTestWorldKnowsItsPlace) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/navsat.sdf");
  std::vector<ignition::msgs::NavSat> messages;
  world.listen("/world/navsat_sensor/model/navsat_model/link/link/sensor/navsat_sensor/navsat", messages);
  world.step(100);
  ASSERT_GE(messages.size(), 3U);
  EXPECT_NEAR(messages[0].latitude_deg(), -22.9, 1e-6);
  EXPECT_NEAR(messages[0].longitude_deg(), -43.2, 1e-6);
  EXPECT_LT(messages.back().velocity_up(), -0.5);
}

TEST(NavSat, FollowsAWorldThatIsToldToBeSomewhereElse) {
  RunningWorld world(worldWith(kEarth, "0 0 0 0 0 0"));
  std::vector<ignition::msgs::NavSat> messages;
  world.listen(kTopic, messages);
  world.step(1);
  EXPECT_TRUE(world.simulation().world().setPlace({0.5, -0.5, 0}, 0));
  world.step(1);
  ASSERT_EQ(messages.size(), 2);
  EXPECT_NEAR(messages[0].latitude_deg(), 10, 1e-5);
  EXPECT_NEAR(messages[1].latitude_deg(), 0.5 * 180 / std::numbers::pi, 1e-5);
}

}  // namespace
}  // namespace pongsim::navsat_test
