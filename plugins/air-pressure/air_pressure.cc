#include <ignition/msgs/fluid_pressure.pb.h>

#include <cmath>
#include <list>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/noise.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Pressure of the International Standard Atmosphere below 11 km.
/// @param height Above the sea [m].
/// @return [Pa]
double pressureAt(double height) {
  constexpr double kEarthRadius = 6356766;  // [m]
  constexpr double kTemperature = 288.15;   // at the sea [K]
  constexpr double kGradient = -0.0065;     // [K/m]
  constexpr double kPressure = 101325;      // at the sea [Pa]
  constexpr double kGravity = 9.80665;      // [m/s^2]
  constexpr double kMolarMass = 28.9644;    // [kg/kmol]
  constexpr double kGasConstant = 8314.32;  // [N m/(kmol K)]
  // U.S. Standard Atmosphere, 1976, equations 18, 23 and 33a
  const double geopotential = kEarthRadius * height / (kEarthRadius + height);
  const double temperature = kTemperature + kGradient * geopotential;
  const double exponent = kGravity * kMolarMass / (kGasConstant * kGradient);
  return kPressure * std::exp(exponent * std::log(kTemperature / temperature));
}

/// One sensor: what it measures, and where it speaks.
class AirPressureSensor {
 public:
  AirPressureSensor(const Sensor& sensor, const World&, Node& node, Random random)
      : sensor_(sensor),
        topic_(sensor, "/air_pressure", "ignition.msgs.FluidPressure", node),
        noise_(sensor.settings<AirPressureSettings>()->pressure, random.split("pressure")) {
    setHeaderValue("frame_id", topic_.frameName(), *message_.mutable_header());
  }

  void update(const StepInfo& info) {
    if (!topic_.isDue(info)) return;
    const double dt = topic_.sinceLast(info);
    setStamp(info.time, *message_.mutable_header());
    setHeaderValue("seq", std::to_string(topic_.count()), *message_.mutable_header());
    measure(dt);
    topic_.publish(message_);
  }

  void reset() { topic_.reset(); }

 private:
  /// @param dt Time since the last message [s].
  void measure(double dt) {
    const NoiseSettings& settings = sensor_.settings<AirPressureSettings>()->pressure;
    message_.set_pressure(noise_.apply(pressureAt(sensor_.pose().position.z()), dt));
    // the root of a deviation is no variance, but what Fortress sends
    const bool isNoisy = settings.type != NoiseSettings::Type::kNone;
    message_.set_variance(isNoisy ? std::sqrt(settings.standardDeviation) : 0);
  }

  Sensor sensor_;
  SensorTopic topic_;
  Noise noise_;
  ignition::msgs::FluidPressure message_;
};

/// Publishes the pressure of the air at the world's air pressure sensors.
class AirPressure : public System {
 public:
  void configure(const SystemContext& context) override {
    for (const Sensor& sensor : context.world.sensors("air_pressure")) {
      sensors_.emplace_back(sensor, context.world, context.node, context.random.split(sensor.scopedName()));
    }
  }

  void postUpdate(const StepInfo& info) override {
    for (AirPressureSensor& sensor : sensors_) sensor.update(info);
  }

  void reset() override {
    for (AirPressureSensor& sensor : sensors_) sensor.reset();
  }

 private:
  std::list<AirPressureSensor> sensors_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AirPressure, "ignition::gazebo::systems::AirPressure", "gz::sim::systems::AirPressure");
