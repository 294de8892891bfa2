#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::trajectory_follower_test {
namespace {

using test::RunningWorld;

std::string plugin(const std::string& parameters) {
  return "<plugin filename='ignition-gazebo-trajectory-follower-system' "
         "name='ignition::gazebo::systems::TrajectoryFollower'>" +
         parameters + "</plugin>";
}

/// A crate of 2 kg that nothing brakes.
std::string floating(const std::string& parameters, const std::string& pose = "0 0 0 0 0 0") {
  return "<gravity>0 0 0</gravity><model name='m'><pose>" + pose +
         "</pose><link name='body'><inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>"
         "</inertia></inertial></link>" +
         plugin("<link_name>body</link_name>" + parameters) + "</model>";
}

/// A crate of 2 kg that slides on a ground, which holds it as long as nothing pushes it.
std::string sliding(const std::string& parameters) {
  return "<model name='ground'><static>true</static><link name='link'><collision name='c'><geometry><plane><normal>0 0 "
         "1</normal></plane></geometry><surface><friction><ode><mu>0.5</mu><mu2>0.5</mu2></ode></friction></surface>"
         "</collision></link></model><model name='m'><pose>0 0 0.25 0 0 0</pose><link name='body'><inertial><mass>2"
         "</mass><inertia><ixx>0.083</ixx><iyy>0.083</iyy><izz>0.083</izz></inertia></inertial><collision name='c'>"
         "<geometry><box><size>0.5 0.5 0.5</size></box></geometry></collision></link>" +
         plugin("<link_name>body</link_name><force>15</force><torque>4</torque><range_tolerance>0.2</range_tolerance>" +
                parameters) +
         "</model>";
}

std::string waypoints(const std::vector<std::string>& points) {
  std::string text = "<waypoints>";
  for (const std::string& point : points) text += "<waypoint>" + point + "</waypoint>";
  return text + "</waypoints>";
}

Link bodyOf(RunningWorld& world) { return world.model("m").link("body").value(); }

/// Steps on until the body is within a distance of the point.
/// @return Whether it came there within 20 s.
bool comesTo(RunningWorld& world, const Vector3& point, double distance = 0.2) {
  for (int i = 0; i < 20000; ++i) {
    if ((bodyOf(world).pose().position - point).head<2>().norm() <= distance) return true;
    world.step(1);
  }
  return false;
}

void pause(RunningWorld& world, const std::string& topic, bool pauses) {
  ignition::msgs::Boolean message;
  message.set_data(pauses);
  world.tell(topic, message);
}

TEST(TrajectoryFollower, PushesAheadWhereItFacesThePoint) {
  RunningWorld world(floating(waypoints({"50 0"})));
  world.step(500);
  // 60 N by default, 2 kg
  EXPECT_NEAR((bodyOf(world).linearVelocity() - Vector3(15, 0, 0)).norm(), 0, 1e-9);
  EXPECT_EQ(bodyOf(world).angularVelocity().norm(), 0);
}

TEST(TrajectoryFollower, TurnsFirstWhereItDoesNot) {
  RunningWorld world(floating(waypoints({"0 -50"})));
  world.step(20);
  // 50 N m by default, 0.1 kg m^2
  EXPECT_NEAR((bodyOf(world).angularVelocity() - Vector3(0, 0, -10)).norm(), 0, 1e-9);
  EXPECT_EQ(bodyOf(world).linearVelocity().norm(), 0);
}

TEST(TrajectoryFollower, TakesItsForceAndTolerancesFromTheFile) {
  RunningWorld ahead(floating(waypoints({"50 5"}) + "<force>4</force><bearing_tolerance>6</bearing_tolerance>"));
  ahead.step(500);
  EXPECT_NEAR(bodyOf(ahead).linearVelocity().x(), 1, 1e-9);
  RunningWorld turning(floating(waypoints({"50 5"}) + "<torque>0.01</torque><bearing_tolerance>3</bearing_tolerance>"));
  turning.step(500);
  EXPECT_NEAR(bodyOf(turning).angularVelocity().z(), 0.05, 1e-6);
  RunningWorld there(floating(waypoints({"50 5"}) + "<range_tolerance>51</range_tolerance>"));
  there.step(500);
  EXPECT_EQ(bodyOf(there).linearVelocity().norm(), 0);
  EXPECT_EQ(bodyOf(there).angularVelocity().norm(), 0);
}

TEST(TrajectoryFollower, PushesAlongTheAxesOfTheInertia) {
  std::string text = floating(waypoints({"50 0"}));
  const std::string mass = "<inertial>";
  text.insert(text.find(mass) + mass.size(), "<pose>0 0 0 0 0 1.5707963267948966</pose>");
  RunningWorld world(text);
  world.step(100);
  EXPECT_NEAR((bodyOf(world).linearVelocity() - Vector3(0, 3, 0)).norm(), 0, 1e-9);
}

TEST(TrajectoryFollower, VisitsItsWaypointsOverAndOver) {
  RunningWorld world(sliding(waypoints({"1.5 0", "1.5 1.5", "0 0"}) + "<loop>true</loop>"));
  for (int round = 0; round < 2; ++round) {
    for (const Vector3& point : {Vector3(1.5, 0, 0), Vector3(1.5, 1.5, 0), Vector3(0, 0, 0)}) {
      EXPECT_TRUE(comesTo(world, point)) << round << ": " << point.transpose();
    }
  }
}

TEST(TrajectoryFollower, StaysAtTheLastOneAndComesBackToIt) {
  RunningWorld world(sliding(waypoints({"0.5 0", "1.5 0"})));
  EXPECT_TRUE(comesTo(world, {1.5, 0, 0}));
  world.step(5000);
  EXPECT_NEAR(bodyOf(world).pose().position.x(), 1.5, 0.25);
  ASSERT_TRUE(world.model("m").setPose({{3, 1, 0.25}, Quaternion::Identity()}));
  EXPECT_TRUE(comesTo(world, {1.5, 0, 0}));
}

TEST(TrajectoryFollower, GoesRoundTheStart) {
  RunningWorld world(sliding("<circle><radius>1.5</radius></circle><loop>true</loop>"));
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(comesTo(world, 1.5 * Vector3(std::cos(i * M_PI / 4), std::sin(i * M_PI / 4), 0))) << i;
  }
}

TEST(TrajectoryFollower, PausesAndGoesOn) {
  RunningWorld world(sliding("<line><direction>0</direction><length>4</length></line>"));
  const std::string topic = "/model/m/trajectory_follower/pause";
  pause(world, topic, true);
  world.step(500);
  EXPECT_NEAR(bodyOf(world).pose().position.x(), 0, 1e-3);
  pause(world, topic, false);
  world.step(1000);
  const double before = bodyOf(world).pose().position.x();
  EXPECT_GT(before, 0.5);
  pause(world, topic, true);
  // it slides on for a while
  world.step(2000);
  EXPECT_NEAR(bodyOf(world).linearVelocity().norm(), 0, 1e-3);
  pause(world, topic, false);
  EXPECT_TRUE(comesTo(world, {4, 0, 0}));
}

TEST(TrajectoryFollower, ListensToTheTopicThatTheWorldNames) {
  RunningWorld world(floating(waypoints({"50 0"}) + "<topic>hold it</topic>"));
  pause(world, "/hold_it", true);
  world.step(100);
  EXPECT_EQ(bodyOf(world).linearVelocity().norm(), 0);
}

// bang-bang about the goal: without friction it would swing for ever
TEST(TrajectoryFollower, StopsTurningWhereItFacesThePoint) {
  RunningWorld swinging(floating(waypoints({"0 500"}) + "<torque>0.5</torque>"));
  swinging.step(3000);
  EXPECT_GT(bodyOf(swinging).angularVelocity().norm(), 0.05);
  RunningWorld world(floating(waypoints({"0 500"}) +
                              "<torque>0.5</torque><zero_vel_on_bearing_reached>true</zero_vel_on_bearing_reached>"));
  world.step(3000);
  EXPECT_LT(bodyOf(world).angularVelocity().norm(), 1e-9);
  EXPECT_GT(bodyOf(world).linearVelocity().y(), 10);
}

TEST(TrajectoryFollower, StartsAnewAfterAReset) {
  RunningWorld world(sliding(waypoints({"1.5 0", "1.5 1.5", "0 0"}) + "<loop>true</loop>"));
  world.step(4000);
  const std::uint64_t hash = world.simulation().stateHash();
  pause(world, "/model/m/trajectory_follower/pause", true);
  world.step(1);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  world.step(4000);
  EXPECT_EQ(world.simulation().stateHash(), hash);
}

TEST(TrajectoryFollower, GoesOnFromASavedState) {
  // a circle around where it has started, not around where it is
  const std::string text = sliding("<circle><radius>1.5</radius></circle><loop>true</loop>");
  RunningWorld world(text);
  world.step(3000);
  const std::vector<std::byte> state = world.simulation().saveState();
  world.step(3000);
  RunningWorld other(text);
  ASSERT_TRUE(other.simulation().restoreState(state));
  other.step(3000);
  EXPECT_EQ(other.simulation().stateHash(), world.simulation().stateHash());
}

TEST(TrajectoryFollower, SaysWhatIsWrongWithIt) {
  const std::string left = "trajectory-follower of m is left out: ";
  const std::array<std::array<std::string, 2>, 6> cases{{
      {"", left + "no path is given"},
      {"<waypoints></waypoints>", left + "<waypoints> has no <waypoint>"},
      {"<circle/>", left + "no <radius> is given"},
      {"<force>-1</force>" + waypoints({"1 2"}), left + "<force> must be zero or more"},
      {"<range_tolerance>-1</range_tolerance>" + waypoints({"1 2"}), left + "<range_tolerance> must be zero or more"},
      {"<speed>1</speed>" + waypoints({"1 2"}), "trajectory-follower of m does not know <speed>"},
  }};
  for (const auto& [parameters, expected] : cases) {
    EXPECT_EQ(RunningWorld::complaintsAbout(floating(parameters)), std::vector<std::string>{expected}) << parameters;
  }
  std::string text = floating(waypoints({"1 2"}));
  const std::string name = "<link_name>body";
  EXPECT_EQ(RunningWorld::complaintsAbout(text.replace(text.find(name), name.size(), "<link_name>trunk")),
            std::vector<std::string>{left + "<link_name> 'trunk' is not a link of model 'm'"});
}

}  // namespace
}  // namespace pongsim::trajectory_follower_test
