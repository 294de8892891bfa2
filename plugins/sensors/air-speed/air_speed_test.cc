#include <gtest/gtest.h>
#include <ignition/msgs/air_speed.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/running_world.hh"

namespace pongsim::air_speed_test {
namespace {

using ignition::msgs::AirSpeed;
using test::RunningWorld;

struct Flight {
  std::string pose = "0 0 0 0 0 0";
  Vector3 velocity = Vector3::Zero();
  std::string wind = "0 0 0";
  /// Content of the sensor.
  std::string sensor = {};
};

std::string worldWith(const Flight& flight) {
  return "<gravity>0 0 0</gravity><wind><linear_velocity>" + flight.wind +
         "</linear_velocity></wind><plugin filename='gz-sim-air-speed-system' name='gz::sim::systems::AirSpeed'/>"
         "<model name='m'><pose>" +
         flight.pose + "</pose><link name='l'><inertial><mass>1</mass></inertial><sensor name='s' type='air_speed'>" +
         flight.sensor + "</sensor></link></model>";
}

AirSpeed measure(const Flight& flight) {
  RunningWorld world(worldWith(flight));
  world.model("m").setVelocity(flight.velocity, Vector3::Zero());
  std::vector<AirSpeed> messages;
  world.listen("/world/w/model/m/link/l/sensor/s/air_speed", messages);
  world.step(10);
  EXPECT_EQ(messages.size(), 10U);
  return messages.at(9);
}

/// The speed that an autopilot computes from a reading at the sea [m/s].
double speedOf(const AirSpeed& message) { return std::sqrt(2 * message.diff_pressure() / 1.225); }

TEST(AirSpeed, IsThatOfTheSensorAlongItsXAxis) {
  EXPECT_NEAR(speedOf(measure({.velocity = {30, 0, 0}})), 30, 1e-9);
  EXPECT_NEAR(measure({.velocity = {0, 30, 0}}).diff_pressure(), 0, 1e-12);
  // flies to the north, and the nose is 60 degrees from there
  EXPECT_NEAR(speedOf(measure({.pose = "0 0 0 0 0 0.5235987755982988", .velocity = {0, 30, 0}})), 15, 1e-9);
  EXPECT_EQ(measure({.velocity = {30, 0, 0}}).header().data(0).value(0), "m::l::s");
}

TEST(AirSpeed, IsNegativeFromBehind) {
  EXPECT_NEAR(measure({.velocity = {-10, 0, 0}}).diff_pressure(), -1.225 / 2 * 100, 1e-9);
}

TEST(AirSpeed, IsRelativeToTheWind) {
  EXPECT_NEAR(speedOf(measure({.velocity = {20, 0, 0}, .wind = "-5 3 0"})), 25, 1e-9);
  EXPECT_NEAR(measure({.velocity = {20, 0, 0}, .wind = "20 0 0"}).diff_pressure(), 0, 1e-12);
}

// 0.7364 kg/m^3 and 255.65 K at 5 km: U.S. Standard Atmosphere, 1976, table I
TEST(AirSpeed, FallsWithTheDensityOfTheAir) {
  const AirSpeed message = measure({.pose = "0 0 5000 0 0 0", .velocity = {30, 0, 0}});
  EXPECT_NEAR(message.temperature(), 255.65, 0.01);
  EXPECT_NEAR(message.diff_pressure(), 0.7364 / 2 * 900, 0.2);
  EXPECT_NEAR(measure({}).temperature(), 288.15, 1e-12);
  const AirSpeed above = measure({.pose = "0 0 1e6 0 0 0", .velocity = {30, 0, 0}});
  EXPECT_EQ(above.diff_pressure(), 0);
  EXPECT_EQ(above.temperature(), 0);
}

TEST(AirSpeed, HasNoiseInHectopascals) {
  const std::string noise = "<air_speed><pressure><noise type='gaussian'><mean>2</mean></noise></pressure></air_speed>";
  EXPECT_NEAR(measure({.velocity = {30, 0, 0}, .sensor = noise}).diff_pressure(), 1.225 / 2 * 900 + 200, 1e-9);
}

TEST(AirSpeed, SaysWhatIsWrongWithItsNoise) {
  const std::string noise =
      "<air_speed><pressure><noise type='gaussian'><stddev>-1</stddev></noise></pressure></air_speed>";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith({.sensor = noise})),
            std::vector<std::string>{"<stddev> must be zero or more: it is left out"});
}

}  // namespace
}  // namespace pongsim::air_speed_test
