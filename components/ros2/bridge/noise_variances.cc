#include "ros2/bridge/noise_variances.hh"

#include <string>

#include "pongsim/node.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::ros2 {

namespace {

double varianceOf(const NoiseSettings& noise) {
  return noise.type == NoiseSettings::Type::kNone ? 0 : noise.standardDeviation * noise.standardDeviation;
}

std::array<double, 3> variancesOf(const NoiseSettings3& noise) {
  return {varianceOf(noise[0]), varianceOf(noise[1]), varianceOf(noise[2])};
}

/// @return The topic of a sensor, as those of the simulation are written.
std::string topicOf(const Sensor& sensor, const std::string& suffix) {
  const std::string topic = cleanTopic(sensor.topic(suffix));
  return topic.starts_with('/') ? topic : "/" + topic;
}

Variances variancesOf(const Sensor& sensor) {
  Variances variances;
  if (const auto* imu = sensor.settings<ImuSettings>()) {
    variances = {variancesOf(imu->angularVelocity), variancesOf(imu->linearAcceleration)};
  } else if (const auto* magnetometer = sensor.settings<MagnetometerSettings>()) {
    variances.reading = variancesOf(magnetometer->field);
  } else if (const auto* navSat = sensor.settings<NavSatSettings>()) {
    const double horizontal = varianceOf(navSat->horizontalPosition);
    variances.reading = {horizontal, horizontal, varianceOf(navSat->verticalPosition)};
  } else if (const auto* barometer = sensor.settings<AirPressureSettings>()) {
    variances.reading[0] = varianceOf(barometer->pressure);
  }
  return variances;
}

}  // namespace

NoiseVariances noiseVariances(const World& world) {
  NoiseVariances all;
  for (const char* type : {"imu", "magnetometer", "navsat", "air_pressure"}) {
    for (const Sensor& sensor : world.sensors(type)) {
      const Variances variances = variancesOf(sensor);
      if (variances != Variances{}) all.emplace(topicOf(sensor, "/" + std::string(type)), variances);
    }
  }
  return all;
}

}  // namespace pongsim::ros2
