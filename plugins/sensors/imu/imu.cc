#include <ignition/msgs/imu.pb.h>

#include <numbers>

#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kQuarterTurn = std::numbers::pi / 2;

/// @return Orientation of a sensor's reference frame in the world.
Quaternion referenceOf(const Sensor& sensor, const ImuSettings& settings, const World& world) {
  // the world's frame is ENU, rotated by its heading
  const Quaternion heading = fromRollPitchYaw(0, 0, world.heading());
  if (settings.localization == "ENU") return heading;
  if (settings.localization == "CUSTOM") return heading * settings.customRotation;
  if (settings.localization == "NED") return heading * fromRollPitchYaw(kHalfTurn, 0, kQuarterTurn);
  if (settings.localization == "NWU") return heading * fromRollPitchYaw(0, 0, kQuarterTurn);
  return sensor.pose().rotation;
}

class ImuSensor final : public SensorOf<ignition::msgs::IMU> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of inertial measurement units (IMUs).", .type = "imu", .suffix = "/imu"};

  explicit ImuSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        world_(context.world),
        settings_(*sensor_.settings<ImuSettings>()),
        accelerationNoise_(context.noises.add(settings_.linearAcceleration, "acceleration")),
        turnNoise_(context.noises.add(settings_.angularVelocity, "turn")),
        q_WorldReference_(referenceOf(sensor_, settings_, world_)),
        lastVelocity_(sensor_.linearVelocity()) {
    message().set_entity_name(sensor_.scopedName());
  }

  // in each step, because an acceleration is a difference of velocities
  void observe(const StepInfo& info) override {
    const Vector3 velocity = sensor_.linearVelocity();
    acceleration_ = (velocity - lastVelocity_) / toSeconds(info.dt) - world_.gravity();
    lastVelocity_ = velocity;
  }

  void measure() override {
    const Quaternion q_WorldSensor = sensor_.pose().rotation;
    const Quaternion q_SensorWorld = q_WorldSensor.conjugate();
    if (settings_.enableOrientation) {
      setRotation(q_WorldReference_.conjugate() * q_WorldSensor, *message().mutable_orientation());
    }
    setVector(accelerationNoise_.apply(q_SensorWorld * acceleration_), *message().mutable_linear_acceleration());
    setVector(turnNoise_.apply(q_SensorWorld * sensor_.link().angularVelocity()),
              *message().mutable_angular_velocity());
  }

  void reset() override { lastVelocity_ = sensor_.linearVelocity(); }

  void transfer(StateArchive& archive) override {
    archive(lastVelocity_);
    archive(acceleration_);
  }

 private:
  Sensor sensor_;
  World world_;
  ImuSettings settings_;
  Noise3 accelerationNoise_;
  Noise3 turnNoise_;
  Quaternion q_WorldReference_;
  Vector3 lastVelocity_;
  /// Acceleration minus gravity, world frame [m/s^2].
  Vector3 acceleration_ = Vector3::Zero();
};

using Imu = SensorSystemFor<ImuSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Imu, "ignition::gazebo::systems::Imu", "gz::sim::systems::Imu");
