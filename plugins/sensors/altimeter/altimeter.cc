#include <ignition/msgs/altimeter.pb.h>

#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

struct AltimeterSensor {
  using Message = ignition::msgs::Altimeter;
  static constexpr const char* kType = "altimeter";
  static constexpr const char* kSuffix = "/altimeter";
  static constexpr const char* kText =
      "Publishes the readings of altimeters: height above their start and vertical velocity.";

  AltimeterSensor(const Sensor& sensor, const World&, NoiseSet& noises, Message& message)
      : sensor_(sensor),
        positionNoise_(noises.add(sensor.settings<AltimeterSettings>()->verticalPosition, "position")),
        velocityNoise_(noises.add(sensor.settings<AltimeterSettings>()->verticalVelocity, "velocity")),
        reference_(sensor.pose().position.z()) {
    message.set_vertical_reference(reference_);
  }

  void measure(Message& message) {
    message.set_vertical_position(positionNoise_.apply(sensor_.pose().position.z() - reference_));
    message.set_vertical_velocity(velocityNoise_.apply(sensor_.linearVelocity().z()));
  }

 private:
  Sensor sensor_;
  Noise& positionNoise_;
  Noise& velocityNoise_;
  /// Height at the start [m].
  double reference_;
};

using Altimeter = SensorSystem<AltimeterSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Altimeter, "ignition::gazebo::systems::Altimeter", "gz::sim::systems::Altimeter");
