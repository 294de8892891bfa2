#include <ignition/msgs/wrench.pb.h>

#include <optional>

#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

/// @return The joint that contains a sensor.
Joint jointOf(const Sensor& sensor) {
  if (!sensor.joint()) {
    refuse(sensor.sdf(), "sensor '" + sensor.scopedName() + "' is in a link", "it belongs in a <joint>");
  }
  return *sensor.joint();
}

class ForceTorqueSensor final : public SensorOf<ignition::msgs::Wrench> {
 public:
  static constexpr SensorKind kKind{.text = "Publishes the readings of force-torque sensors in joints.",
                                    .type = "force_torque",
                                    .suffix = "/forcetorque",
                                    .holder = "joint/J"};

  explicit ForceTorqueSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        joint_(jointOf(sensor_)),
        settings_(*sensor_.settings<ForceTorqueSettings>()),
        forceNoise_(context.noises.add(settings_.force, "force")),
        torqueNoise_(context.noises.add(settings_.torque, "torque")) {
    reset();
  }

  /// The engine records a joint's reaction from the first time it is asked for.
  void reset() final { joint_.reaction(); }

  void measure() override {
    const Wrench reaction = joint_.reaction();
    const double sign = settings_.isParentToChild ? 1 : -1;
    // torque about the sensor instead of the joint
    const Vector3 arm = sensor_.pose().position - (joint_.child().pose() * joint_.poseInChild()).position;
    const Quaternion q_AxesWorld = axes().conjugate();
    const Vector3 force = q_AxesWorld * (sign * reaction.force);
    const Vector3 torque = q_AxesWorld * (sign * (reaction.torque - arm.cross(reaction.force)));
    setVector(forceNoise_.apply(force), *message().mutable_force());
    setVector(torqueNoise_.apply(torque), *message().mutable_torque());
  }

 private:
  /// @return Orientation in the world of the axes of the values.
  Quaternion axes() const {
    using Frame = ForceTorqueSettings::Frame;
    if (settings_.frame == Frame::kSensor) return sensor_.pose().rotation;
    if (settings_.frame == Frame::kChild) return joint_.child().pose().rotation;
    const std::optional<Link> parent = joint_.parent();
    return parent ? parent->pose().rotation : Quaternion::Identity();
  }

  Sensor sensor_;
  Joint joint_;
  ForceTorqueSettings settings_;
  Noise3 forceNoise_;
  Noise3 torqueNoise_;
};

using ForceTorque = SensorSystemFor<ForceTorqueSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ForceTorque, "ignition::gazebo::systems::ForceTorque", "gz::sim::systems::ForceTorque");
