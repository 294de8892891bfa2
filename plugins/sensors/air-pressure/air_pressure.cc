#include <ignition/msgs/fluid_pressure.pb.h>

#include <cmath>

#include "pongsim/math.hh"
#include "pongsim/sensing/sensor_system.hh"

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
  return kPressure * math::exp(exponent * math::log(kTemperature / temperature));
}

class AirPressureSensor final : public SensorOf<ignition::msgs::FluidPressure> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of air pressure sensors.", .type = "air_pressure", .suffix = "/air_pressure"};

  explicit AirPressureSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        noise_(context.noises.add(sensor_.settings<AirPressureSettings>()->pressure, "pressure")) {
    const NoiseSettings& settings = sensor_.settings<AirPressureSettings>()->pressure;
    // the root of a standard deviation is no variance, but Fortress sends that
    const bool isNoisy = settings.type != NoiseSettings::Type::kNone;
    message().set_variance(isNoisy ? std::sqrt(settings.standardDeviation) : 0);
  }

  void measure() override { message().set_pressure(noise_.apply(pressureAt(sensor_.pose().position.z()))); }

 private:
  Sensor sensor_;
  Noise& noise_;
};

using AirPressure = SensorSystemFor<AirPressureSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AirPressure, "ignition::gazebo::systems::AirPressure", "gz::sim::systems::AirPressure");
