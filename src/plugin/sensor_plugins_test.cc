#include "plugin/sensor_plugins.hh"

#include <gtest/gtest.h>

namespace pongsim::plugin {
namespace {

description::Sensor sensor(const std::string& name, const std::string& type) {
  description::Sensor made;
  made.name = name;
  made.type = type;
  made.position = {std::make_shared<const std::string>("world.sdf"), 12, 5};
  return made;
}

class SensorCheckTest : public testing::Test {
 protected:
  std::string report() {
    Diagnostics diagnostics;
    check_.report(diagnostics);
    EXPECT_LE(diagnostics.all().size(), 1U);
    return diagnostics.all().empty() ? "" : format(diagnostics.all().front());
  }

  SensorCheck check_;
};

TEST_F(SensorCheckTest, NamesThePluginThatIsMissing) {
  const description::Sensor imu = sensor("imu", "imu");
  check_.add(imu);
  EXPECT_EQ(report(),
            "world.sdf:12:5: warning: sensor 'imu' (imu) publishes nothing: no plugin of the world simulates it\n"
            "  hint: add to the <world> <plugin filename=\"ignition-gazebo-imu-system\" "
            "name=\"ignition::gazebo::systems::Imu\"/>");
}

TEST_F(SensorCheckTest, SumsUpSensorsAndTheirPlugins) {
  const description::Sensor all[] = {sensor("scan", "gpu_lidar"), sensor("eye", "camera"), sensor("imu", "imu")};
  for (const description::Sensor& each : all) check_.add(each);
  EXPECT_EQ(report(),
            "world.sdf:12:5: warning: sensor 'scan' (gpu_lidar) and 2 others publish nothing: no plugin of the world "
            "simulates them\n"
            "  hint: add to the <world> <plugin filename=\"ignition-gazebo-sensors-system\" "
            "name=\"ignition::gazebo::systems::Sensors\"/> <plugin filename=\"ignition-gazebo-imu-system\" "
            "name=\"ignition::gazebo::systems::Imu\"/>");
}

TEST_F(SensorCheckTest, NamesThePluginsOfLaterReleasesAsTheyDo) {
  const description::Sensor all[] = {sensor("pitot", "air_speed"), sensor("log", "dvl")};
  for (const description::Sensor& each : all) check_.add(each);
  EXPECT_EQ(report(),
            "world.sdf:12:5: warning: sensor 'pitot' (air_speed) and another one publish nothing: no plugin of the "
            "world simulates them\n"
            "  hint: add to the <world> <plugin filename=\"gz-sim-air-speed-system\" "
            "name=\"gz::sim::systems::AirSpeed\"/> <plugin filename=\"gz-sim-dvl-system\" "
            "name=\"gz::sim::systems::DopplerVelocityLogSystem\"/>");
}

TEST_F(SensorCheckTest, IsSilentWhereAllIsSimulatedOrNothingCouldBe) {
  Declaration declaration;
  declaration.measures({.sensorType = "imu"});
  check_.add(declaration);
  const description::Sensor imu = sensor("imu", "imu"), custom = sensor("own", "custom");
  check_.add(imu);
  check_.add(custom);
  EXPECT_EQ(report(), "");
}

}  // namespace
}  // namespace pongsim::plugin
