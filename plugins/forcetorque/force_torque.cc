#include <ignition/msgs/wrench.pb.h>

#include <list>
#include <optional>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/noise.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// One sensor: what it measures, and where it speaks.
class ForceTorqueSensor {
 public:
  ForceTorqueSensor(const Sensor& sensor, const World&, Node& node, Random random)
      : sensor_(sensor),
        topic_(sensor, "/forcetorque", "ignition.msgs.Wrench", node),
        joint_(sensor.joint().value()),
        settings_(*sensor.settings<ForceTorqueSettings>()),
        forceNoise_(settings_.force, random),
        torqueNoise_(settings_.torque, random) {
    setHeaderValue("frame_id", topic_.frameName(), *message_.mutable_header());
    // begins the measuring
    joint_.reaction();
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
    const Wrench reaction = joint_.reaction();
    const double sign = settings_.isParentToChild ? 1 : -1;
    // at the sensor, in place of the joint
    const Vector3 arm = sensor_.pose().position - (joint_.child().pose() * joint_.poseInChild()).position;
    const Quaternion q_AxesWorld = axes().conjugate();
    const Vector3 force = q_AxesWorld * (sign * reaction.force);
    const Vector3 torque = q_AxesWorld * (sign * (reaction.torque - arm.cross(reaction.force)));
    setVector(forceNoise_.apply(force, dt), *message_.mutable_force());
    setVector(torqueNoise_.apply(torque, dt), *message_.mutable_torque());
  }

  /// @return Orientation in the world of the axes that the values are given in.
  Quaternion axes() const {
    using Frame = ForceTorqueSettings::Frame;
    if (settings_.frame == Frame::kSensor) return sensor_.pose().rotation;
    if (settings_.frame == Frame::kChild) return joint_.child().pose().rotation;
    const std::optional<Link> parent = joint_.parent();
    return parent ? parent->pose().rotation : Quaternion::Identity();
  }

  Sensor sensor_;
  SensorTopic topic_;
  Joint joint_;
  ForceTorqueSettings settings_;
  Noise3 forceNoise_;
  Noise3 torqueNoise_;
  ignition::msgs::Wrench message_;
};

/// Publishes what the joints with force-torque sensors carry.
class ForceTorque : public System {
 public:
  void configure(const SystemContext& context) override {
    for (const Sensor& sensor : context.world.sensors("force_torque")) {
      if (!sensor.joint()) {
        context.log.warning("line " + std::to_string(sensor.sdf().position.line) + ": sensor '" + sensor.scopedName() +
                            "' stands in a link: a force-torque sensor belongs in a <joint>");
        continue;
      }
      sensors_.emplace_back(sensor, context.world, context.node, context.random.split(sensor.scopedName()));
    }
  }

  void postUpdate(const StepInfo& info) override {
    for (ForceTorqueSensor& sensor : sensors_) sensor.update(info);
  }

  void reset() override {
    for (ForceTorqueSensor& sensor : sensors_) sensor.reset();
  }

 private:
  std::list<ForceTorqueSensor> sensors_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ForceTorque, "ignition::gazebo::systems::ForceTorque", "gz::sim::systems::ForceTorque");
