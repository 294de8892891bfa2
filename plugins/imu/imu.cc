#include <ignition/msgs/imu.pb.h>

#include <list>
#include <numbers>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/noise.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kQuarterTurn = std::numbers::pi / 2;

/// @return Orientation in the world of what a sensor's orientation is measured in.
Quaternion referenceOf(const Sensor& sensor, const ImuSettings& settings, const World& world) {
  // the world's frame is ENU, turned by its heading
  const Quaternion heading = fromRollPitchYaw(0, 0, world.heading());
  if (settings.localization == "ENU") return heading;
  if (settings.localization == "CUSTOM") return heading * settings.customRotation;
  if (settings.localization == "NED") return heading * fromRollPitchYaw(kHalfTurn, 0, kQuarterTurn);
  if (settings.localization == "NWU") return heading * fromRollPitchYaw(0, 0, kQuarterTurn);
  return sensor.pose().rotation;
}

/// One sensor: what it measures, and where it speaks.
class ImuSensor {
 public:
  ImuSensor(const Sensor& sensor, const World& world, Node& node, Random random)
      : sensor_(sensor),
        settings_(*sensor.settings<ImuSettings>()),
        topic_(sensor, "/imu", "ignition.msgs.IMU", node),
        accelerationNoise_(settings_.linearAcceleration, random),
        turnNoise_(settings_.angularVelocity, random),
        q_WorldReference_(referenceOf(sensor, settings_, world)),
        lastVelocity_(sensor.linearVelocity()) {
    message_.set_entity_name(sensor.scopedName());
    setHeaderValue("frame_id", topic_.frameName(), *message_.mutable_header());
  }

  /// Called in each step, for an acceleration is the change of a velocity.
  void update(const StepInfo& info, const Vector3& gravity) {
    const Vector3 velocity = sensor_.linearVelocity();
    if (topic_.isDue(info)) publish(info, (velocity - lastVelocity_) / toSeconds(info.dt) - gravity);
    lastVelocity_ = velocity;
  }

  void reset() {
    topic_.reset();
    lastVelocity_ = sensor_.linearVelocity();
  }

 private:
  /// @param acceleration What holds the sensor against gravity and moves it, world frame [m/s^2].
  void publish(const StepInfo& info, const Vector3& acceleration) {
    const Quaternion q_WorldSensor = sensor_.pose().rotation;
    const Quaternion q_SensorWorld = q_WorldSensor.conjugate();
    const double dt = topic_.sinceLast(info);
    setStamp(info.time, *message_.mutable_header());
    setHeaderValue("seq", std::to_string(topic_.count()), *message_.mutable_header());
    if (settings_.enableOrientation) {
      setRotation(q_WorldReference_.conjugate() * q_WorldSensor, *message_.mutable_orientation());
    }
    setVector(accelerationNoise_.apply(q_SensorWorld * acceleration, dt), *message_.mutable_linear_acceleration());
    setVector(turnNoise_.apply(q_SensorWorld * sensor_.link().angularVelocity(), dt),
              *message_.mutable_angular_velocity());
    topic_.publish(message_);
  }

  Sensor sensor_;
  ImuSettings settings_;
  SensorTopic topic_;
  Noise3 accelerationNoise_;
  Noise3 turnNoise_;
  Quaternion q_WorldReference_;
  Vector3 lastVelocity_;
  ignition::msgs::IMU message_;
};

/// Publishes what the world's inertial measurement units measure.
class Imu : public System {
 public:
  void configure(const SystemContext& context) override {
    gravity_ = context.world.gravity();
    for (const Sensor& sensor : context.world.sensors("imu")) {
      sensors_.emplace_back(sensor, context.world, context.node, context.random.split(sensor.scopedName()));
    }
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    for (ImuSensor& sensor : sensors_) sensor.update(info, gravity_);
  }

  void reset() override {
    for (ImuSensor& sensor : sensors_) sensor.reset();
  }

 private:
  Vector3 gravity_;
  std::list<ImuSensor> sensors_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Imu, "ignition::gazebo::systems::Imu", "gz::sim::systems::Imu");
