// Lidars and cameras of models whose batteries are empty.

#include <gtest/gtest.h>
#include <ignition/msgs/laserscan.pb.h>

#include <string>
#include <vector>

#include "pongsim/battery.hh"
#include "support/running_world.hh"

namespace pongsim::power_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'>" + parameters +
         R"(</plugin><model name="m"><static>true</static><model name="inner"><link name="l">
      <sensor name="s" type="gpu_lidar"><topic>scan</topic><update_rate>100</update_rate></sensor></link></model>
    </model>)";
}

int scansOf(const std::string& parameters, double charge) {
  RunningWorld world(worldWith(parameters));
  std::vector<ignition::msgs::LaserScan> scans;
  world.listen("/scan", scans);
  EXPECT_TRUE(Batteries(world.simulation().world()).add(world.model("m"), "cell", charge));
  world.step(100);
  return static_cast<int>(scans.size());
}

TEST(SensorPower, EndsWithTheBatteryWhereItIsTold) {
  const std::string rests = "<disable_on_drained_battery>true</disable_on_drained_battery>";
  EXPECT_EQ(scansOf(rests, 0), 0);
  EXPECT_GE(scansOf(rests, 0.1), 10);
  EXPECT_GE(scansOf("", 0), 10);
}

}  // namespace
}  // namespace pongsim::power_test
