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

struct ForceTorqueSensor {
  using Message = ignition::msgs::Wrench;
  static constexpr const char* kType = "force_torque";
  static constexpr const char* kSuffix = "/forcetorque";
  static constexpr const char* kHolder = "joint/J";
  static constexpr const char* kText = "Publishes the readings of force-torque sensors in joints.";

  ForceTorqueSensor(const Sensor& sensor, const World&, NoiseSet& noises, Message&)
      : sensor_(sensor),
        joint_(jointOf(sensor)),
        settings_(*sensor.settings<ForceTorqueSettings>()),
        forceNoise_(noises.add(settings_.force, "force")),
        torqueNoise_(noises.add(settings_.torque, "torque")) {
    reset();
  }

  /// Starts measuring.
  void reset() { joint_.reaction(); }

  void measure(Message& message) {
    const Wrench reaction = joint_.reaction();
    const double sign = settings_.isParentToChild ? 1 : -1;
    // torque about the sensor instead of the joint
    const Vector3 arm = sensor_.pose().position - (joint_.child().pose() * joint_.poseInChild()).position;
    const Quaternion q_AxesWorld = axes().conjugate();
    const Vector3 force = q_AxesWorld * (sign * reaction.force);
    const Vector3 torque = q_AxesWorld * (sign * (reaction.torque - arm.cross(reaction.force)));
    setVector(forceNoise_.apply(force), *message.mutable_force());
    setVector(torqueNoise_.apply(torque), *message.mutable_torque());
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

using ForceTorque = SensorSystem<ForceTorqueSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ForceTorque, "ignition::gazebo::systems::ForceTorque", "gz::sim::systems::ForceTorque");
