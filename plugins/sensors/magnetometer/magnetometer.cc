#include <ignition/msgs/magnetometer.pb.h>

#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

class MagnetometerSensor final : public SensorOf<ignition::msgs::Magnetometer> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of magnetometers.", .type = "magnetometer", .suffix = "/magnetometer"};

  explicit MagnetometerSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        noise_(context.noises.add(sensor_.settings<MagnetometerSettings>()->field, "field")),
        field_(context.world.magneticField()) {}

  void measure() override {
    setVector(noise_.apply(sensor_.pose().rotation.conjugate() * field_), *message().mutable_field_tesla());
  }

 private:
  Sensor sensor_;
  Noise3 noise_;
  /// World frame [T].
  Vector3 field_;
};

using Magnetometer = SensorSystemFor<MagnetometerSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Magnetometer, "ignition::gazebo::systems::Magnetometer",
                      "gz::sim::systems::Magnetometer");
