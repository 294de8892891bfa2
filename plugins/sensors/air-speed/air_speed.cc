#include <ignition/msgs/air_speed.pb.h>

#include <algorithm>
#include <cmath>

#include "pongsim/math.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

// the constants of gz-sensors, at the sea
constexpr double kTemperature = 288.15;     // [K]
constexpr double kDensity = 1.225;          // [kg/m^3]
constexpr double kLapseRate = 0.0065;       // [K/m]
constexpr double kDensityExponent = 4.256;  // of the ratio of temperatures
constexpr double kPascalsPerHectopascal = 100;

/// @param height Above the sea [m].
/// @return [K], not below absolute zero.
double temperatureAt(double height) { return std::max(0.0, kTemperature - kLapseRate * height); }

/// Density of the air in the troposphere.
/// @param temperature [K]
/// @return [kg/m^3]
double densityAt(double temperature) {
  if (temperature <= 0) return 0;
  return kDensity * math::exp(kDensityExponent * math::log(temperature / kTemperature));
}

/// @return The noise of its pressure [hPa].
NoiseSettings noiseOf(const Sensor& sensor) {
  const Element* settings = sensor.sdf().child("air_speed");
  const Element* pressure = settings != nullptr ? settings->child("pressure") : nullptr;
  return pressure != nullptr ? noiseIn(*pressure) : NoiseSettings();
}

class AirSpeedSensor final : public SensorOf<ignition::msgs::AirSpeed> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of air speed sensors.", .type = "air_speed", .suffix = "/air_speed"};

  explicit AirSpeedSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        world_(context.world),
        noise_(context.noises.add(noiseOf(sensor_), "pressure")) {}

  void measure() override {
    const Pose pose = sensor_.pose();
    const double temperature = temperatureAt(pose.position.z());
    const double speed = (pose.rotation.conjugate() * (sensor_.linearVelocity() - world_.wind())).x();
    const double pressure = densityAt(temperature) * speed * std::abs(speed) / 2;
    // Gazebo's noise is in hectopascals, though its readings are in pascals
    message().set_diff_pressure(noise_.apply(pressure / kPascalsPerHectopascal) * kPascalsPerHectopascal);
    message().set_temperature(temperature);
  }

 private:
  Sensor sensor_;
  World world_;
  Noise& noise_;
};

using AirSpeed = SensorSystemFor<AirSpeedSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AirSpeed, "gz::sim::systems::AirSpeed", "ignition::gazebo::systems::AirSpeed");
