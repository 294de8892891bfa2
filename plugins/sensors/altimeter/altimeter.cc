#include <ignition/msgs/altimeter.pb.h>

#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

class AltimeterSensor final : public SensorOf<ignition::msgs::Altimeter> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of altimeters: height above their start and vertical velocity.",
      .type = "altimeter",
      .suffix = "/altimeter"};

  explicit AltimeterSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        positionNoise_(context.noises.add(sensor_.settings<AltimeterSettings>()->verticalPosition, "position")),
        velocityNoise_(context.noises.add(sensor_.settings<AltimeterSettings>()->verticalVelocity, "velocity")),
        reference_(sensor_.pose().position.z()) {
    message().set_vertical_reference(reference_);
  }

  void measure() override {
    message().set_vertical_position(positionNoise_.apply(sensor_.pose().position.z() - reference_));
    message().set_vertical_velocity(velocityNoise_.apply(sensor_.linearVelocity().z()));
  }

 private:
  Sensor sensor_;
  Noise& positionNoise_;
  Noise& velocityNoise_;
  /// Height at the start [m].
  double reference_;
};

using Altimeter = SensorSystemFor<AltimeterSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Altimeter, "ignition::gazebo::systems::Altimeter", "gz::sim::systems::Altimeter");
