#include <gtest/gtest.h>
#include <ignition/msgs/fluid_pressure.pb.h>

#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::air_pressure_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& height, const std::string& sensor) {
  return R"(<gravity>0 0 0</gravity>
    <plugin filename="ignition-gazebo-air-pressure-system" name="ignition::gazebo::systems::AirPressure"/>
    <model name="m"><pose>0 0 )" +
         height +
         R"( 0 0 0</pose><link name="l"><inertial><mass>1</mass></inertial><sensor name="s" type="air_pressure">)" +
         sensor + "</sensor></link></model>";
}

ignition::msgs::FluidPressure measure(const std::string& height, const std::string& sensor) {
  RunningWorld world(worldWith(height, sensor));
  std::vector<ignition::msgs::FluidPressure> messages;
  world.listen("/world/w/model/m/link/l/sensor/s/air_pressure", messages);
  world.step(10);
  EXPECT_EQ(messages.size(), 10U);
  return messages.at(9);
}

// values of the U.S. Standard Atmosphere, 1976, table I
TEST(AirPressure, IsThatOfTheStandardAtmosphere) {
  EXPECT_NEAR(measure("0", "").pressure(), 101325, 0.1);
  EXPECT_NEAR(measure("1000", "").pressure(), 89876, 1);
  EXPECT_NEAR(measure("10000", "").pressure(), 26500, 1);
  EXPECT_EQ(measure("0", "").variance(), 0);
  EXPECT_EQ(measure("0", "").header().data(0).value(0), "m::l::s");
}

TEST(AirPressure, AddsTheNoiseThatTheFileAsksFor) {
  const auto message =
      measure("0",
              "<air_pressure><pressure><noise type='gaussian'><mean>100</mean><stddev>4</stddev></noise></pressure>"
              "</air_pressure>");
  EXPECT_NEAR(message.pressure(), 101425, 25);
  EXPECT_NE(message.pressure(), 101425);
  EXPECT_EQ(message.variance(), 2);
}

TEST(AirPressure, WarnsOfAReferenceThatIsNotUsed) {
  EXPECT_EQ(RunningWorld::complaintsAbout(
                worldWith("0", "<air_pressure><reference_altitude>50</reference_altitude></air_pressure>")),
            std::vector<std::string>{
                "<reference_altitude> has no effect, as in Fortress: altitudes are those in the world frame"});
}

}  // namespace
}  // namespace pongsim::air_pressure_test
