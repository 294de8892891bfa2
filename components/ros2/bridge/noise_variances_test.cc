#include "ros2/bridge/noise_variances.hh"

#include <memory>

#include "support/ros2/robot_world.hh"

namespace pongsim::ros2 {
namespace {

constexpr const char* kNoisyWorld = R"(<sdf version="1.9"><world name="w"><model name="m"><link name="l">
<sensor name="imu" type="imu"><topic>imu</topic><imu>
  <angular_velocity><x><noise type="gaussian"><stddev>0.1</stddev></noise></x>
    <z><noise type="gaussian"><stddev>0.3</stddev></noise></z></angular_velocity>
  <linear_acceleration><y><noise type="gaussian"><stddev>2</stddev></noise></y></linear_acceleration></imu></sensor>
<sensor name="gps" type="navsat"><topic>gps</topic><navsat><position_sensing>
  <horizontal><noise type="gaussian"><stddev>1e-5</stddev></noise></horizontal>
  <vertical><noise type="gaussian"><stddev>3</stddev></noise></vertical></position_sensing></navsat></sensor>
<sensor name="barometer" type="air_pressure"><topic>my pressure</topic><air_pressure><pressure>
  <noise type="gaussian"><stddev>4</stddev></noise></pressure></air_pressure></sensor>
<sensor name="quiet" type="magnetometer"><topic>field</topic></sensor>
</link></model></world></sdf>)";

TEST(NoiseVariancesTest, AreThoseOfTheSensorOnTheTopic) {
  const std::unique_ptr<Simulation> simulation = test::worldOf(kNoisyWorld);
  ASSERT_NE(simulation, nullptr);
  const NoiseVariances all = noiseVariances(simulation->world());
  const Variances& imu = all.at("/imu");
  EXPECT_DOUBLE_EQ(imu.reading[0], 0.01);
  EXPECT_EQ(imu.reading[1], 0);
  EXPECT_DOUBLE_EQ(imu.reading[2], 0.09);
  EXPECT_EQ(imu.acceleration, (std::array<double, 3>{0, 4, 0}));
  const Variances& gps = all.at("/gps");
  EXPECT_DOUBLE_EQ(gps.reading[0], 1e-10);
  EXPECT_EQ(gps.reading[1], gps.reading[0]);
  EXPECT_EQ(gps.reading[2], 9);
  EXPECT_EQ(all.at("/my_pressure").reading[0], 16);
  // no noise
  EXPECT_FALSE(all.contains("/field"));
}

}  // namespace
}  // namespace pongsim::ros2
