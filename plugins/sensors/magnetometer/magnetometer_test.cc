#include <gtest/gtest.h>
#include <ignition/msgs/magnetometer.pb.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::magnetometer_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& sensor) {
  return R"(<gravity>0 0 0</gravity><magnetic_field>1 2 3</magnetic_field>
    <plugin filename="ignition-gazebo-magnetometer-system" name="ignition::gazebo::systems::Magnetometer"/>
    <model name="m"><pose>0 0 0 0 0 1.5707963267948966</pose><link name="l"><inertial><mass>1</mass></inertial>
      <sensor name="s" type="magnetometer">)" +
         sensor + "</sensor></link></model>";
}

TEST(Magnetometer, MeasuresTheWorldsFieldInItsOwnFrame) {
  RunningWorld world(worldWith("<topic>field</topic><update_rate>100</update_rate>"));
  std::vector<ignition::msgs::Magnetometer> messages;
  world.listen("/field", messages);
  world.step(100);
  EXPECT_EQ(messages.size(), 11U);
  EXPECT_NEAR(messages.back().field_tesla().x(), 2, 1e-9);
  EXPECT_NEAR(messages.back().field_tesla().y(), -1, 1e-9);
  EXPECT_NEAR(messages.back().field_tesla().z(), 3, 1e-9);
  EXPECT_EQ(messages.back().header().data(0).value(0), "m::l::s");
}

TEST(Magnetometer, AddsTheNoiseThatTheFileAsksFor) {
  RunningWorld world(worldWith("<magnetometer><y><noise type='gaussian'><mean>5</mean></noise></y></magnetometer>"));
  std::vector<ignition::msgs::Magnetometer> messages;
  world.listen("/world/w/model/m/link/l/sensor/s/magnetometer", messages);
  world.step(1);
  EXPECT_NEAR(messages.at(0).field_tesla().x(), 2, 1e-9);
  EXPECT_NEAR(messages.at(0).field_tesla().y(), 4, 1e-9);
}

}  // namespace
}  // namespace pongsim::magnetometer_test
