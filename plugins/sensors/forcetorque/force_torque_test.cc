#include <gtest/gtest.h>
#include <ignition/msgs/wrench.pb.h>

#include <cmath>

#include <string>
#include <vector>

#include "pongsim/sensing/sensor.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::force_torque_test {
namespace {

using test::RunningWorld;

constexpr const char* kTopic = "/world/w/model/m/joint/weld/sensor/s/forcetorque";

/// An arm of 2 kg, its centre of mass half a metre beside the joint that holds it to a base, turned by a quarter.
std::string worldWith(const std::string& sensor) {
  return R"(<plugin filename="ignition-gazebo-forcetorque-system" name="ignition::gazebo::systems::ForceTorque"/>
    <model name="m"><link name="base"><inertial><mass>1</mass></inertial></link>
    <link name="arm"><pose>0 0 0 0 0 1.5707963267948966</pose><inertial><pose>0 -0.5 0 0 0 0</pose><mass>2</mass>
      </inertial></link>
    <joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="weld" type="fixed"><parent>base</parent><child>arm</child>
      <sensor name="s" type="force_torque">)" +
         sensor + "</sensor></joint></model>";
}

/// Fails a test where the last message is not that.
void expectWrench(const std::string& sensor, const Vector3& force, const Vector3& torque) {
  RunningWorld world(worldWith(sensor));
  std::vector<ignition::msgs::Wrench> messages;
  world.listen(kTopic, messages);
  world.step(200);
  ASSERT_EQ(messages.size(), 200U);
  const ignition::msgs::Wrench& last = messages.back();
  EXPECT_NEAR((Vector3(last.force().x(), last.force().y(), last.force().z()) - force).norm(), 0, 1e-2) << sensor;
  EXPECT_NEAR((Vector3(last.torque().x(), last.torque().y(), last.torque().z()) - torque).norm(), 0, 1e-2) << sensor;
}

TEST(ForceTorque, MeasuresWhatTheChildDoesToItsParent) { expectWrench("", {0, 0, -19.6}, {9.8, 0, 0}); }

TEST(ForceTorque, MeasuresInTheAxesItIsTold) {
  expectWrench("<force_torque><frame>parent</frame></force_torque>", {0, 0, -19.6}, {0, 9.8, 0});
  expectWrench("<pose>0 0 0 3.141592653589793 0 0</pose><force_torque><frame>sensor</frame></force_torque>",
               {0, 0, 19.6}, {9.8, 0, 0});
}

TEST(ForceTorque, MeasuresAtItsOwnPlace) {
  // right at the centre of mass
  expectWrench("<pose>0 -0.5 0 0 0 0</pose>", {0, 0, -19.6}, {0, 0, 0});
}

TEST(ForceTorque, MeasuresTheOtherWayRoundIfItIsTold) {
  expectWrench("<force_torque><measure_direction>parent_to_child</measure_direction></force_torque>", {0, 0, 19.6},
               {-9.8, 0, 0});
}

TEST(ForceTorque, WarnsOfASensorInALink) {
  EXPECT_EQ(
      RunningWorld::complaintsAbout(
          "<plugin filename='ignition-gazebo-forcetorque-system' name='ignition::gazebo::systems::ForceTorque'/><model "
          "name='m'><link name='l'><inertial><mass>1</mass></inertial><sensor name='s' type='force_torque'/></link>"
          "</model>"),
      std::vector<std::string>{"sensor 'm::l::s' is in a link: it is left out"});
}

TEST(ForceTorque, OfFortressTestWorldCarriesTheWeightOnItsPlate) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/force_torque.sdf");
  std::vector<ignition::msgs::Wrench> messages;
  const Sensor sensor = world.simulation().world().sensors("force_torque").at(0);
  world.listen(cleanTopic(sensor.topic("/forcetorque")), messages);
  world.step(3000);
  ASSERT_FALSE(messages.empty());
  // the plate and what lies on it
  EXPECT_NEAR(std::abs(messages.back().force().z()), 10.2 * world.simulation().world().gravity().norm(), 0.5);
}

}  // namespace
}  // namespace pongsim::force_torque_test
