#include <ignition/msgs/magnetometer.pb.h>

#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

struct MagnetometerSensor {
  using Message = ignition::msgs::Magnetometer;
  static constexpr const char* kType = "magnetometer";
  static constexpr const char* kSuffix = "/magnetometer";
  static constexpr const char* kText = "Publishes the readings of magnetometers.";

  MagnetometerSensor(const Sensor& sensor, const World& world, NoiseSet& noises, Message&)
      : sensor_(sensor),
        noise_(noises.add(sensor.settings<MagnetometerSettings>()->field, "field")),
        field_(world.magneticField()) {}

  void measure(Message& message) {
    setVector(noise_.apply(sensor_.pose().rotation.conjugate() * field_), *message.mutable_field_tesla());
  }

 private:
  Sensor sensor_;
  Noise3 noise_;
  /// World frame [T].
  Vector3 field_;
};

using Magnetometer = SensorSystem<MagnetometerSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Magnetometer, "ignition::gazebo::systems::Magnetometer",
                      "gz::sim::systems::Magnetometer");
