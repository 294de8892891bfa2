#include <ignition/msgs/altimeter.pb.h>

#include "pongsim/noise.hh"
#include "pongsim/sensor_system.hh"

namespace pongsim {

namespace {

struct AltimeterSensor {
  using Message = ignition::msgs::Altimeter;
  static constexpr const char* kType = "altimeter";
  static constexpr const char* kSuffix = "/altimeter";
  static constexpr const char* kText =
      "Publishes how high the world's altimeters are above their start, and how fast they climb.";

  AltimeterSensor(const Sensor& sensor, const World&, Random random, Message& message)
      : sensor_(sensor),
        positionNoise_(sensor.settings<AltimeterSettings>()->verticalPosition, random.split("position")),
        velocityNoise_(sensor.settings<AltimeterSettings>()->verticalVelocity, random.split("velocity")),
        reference_(sensor.pose().position.z()) {
    message.set_vertical_reference(reference_);
  }

  void measure(double dt, Message& message) {
    message.set_vertical_position(positionNoise_.apply(sensor_.pose().position.z() - reference_, dt));
    message.set_vertical_velocity(velocityNoise_.apply(sensor_.linearVelocity().z(), dt));
  }

 private:
  Sensor sensor_;
  Noise positionNoise_;
  Noise velocityNoise_;
  /// Height at the start [m].
  double reference_;
};

using Altimeter = SensorSystem<AltimeterSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Altimeter, "ignition::gazebo::systems::Altimeter", "gz::sim::systems::Altimeter");
