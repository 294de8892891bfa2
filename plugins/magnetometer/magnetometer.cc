#include <ignition/msgs/magnetometer.pb.h>

#include <list>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/noise.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// One sensor: what it measures, and where it speaks.
class MagnetometerSensor {
 public:
  MagnetometerSensor(const Sensor& sensor, const World& world, Node& node, Random random)
      : sensor_(sensor),
        topic_(sensor, "/magnetometer", "ignition.msgs.Magnetometer", node),
        noise_(sensor.settings<MagnetometerSettings>()->field, random),
        field_(world.magneticField()) {
    setHeaderValue("frame_id", topic_.frameName(), *message_.mutable_header());
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
    setVector(noise_.apply(sensor_.pose().rotation.conjugate() * field_, dt), *message_.mutable_field_tesla());
  }

  Sensor sensor_;
  SensorTopic topic_;
  Noise3 noise_;
  /// World frame [T].
  Vector3 field_;
  ignition::msgs::Magnetometer message_;
};

/// Publishes the world's magnetic field as its magnetometers measure it.
class Magnetometer : public System {
 public:
  void configure(const SystemContext& context) override {
    for (const Sensor& sensor : context.world.sensors("magnetometer")) {
      sensors_.emplace_back(sensor, context.world, context.node, context.random.split(sensor.scopedName()));
    }
  }

  void postUpdate(const StepInfo& info) override {
    for (MagnetometerSensor& sensor : sensors_) sensor.update(info);
  }

  void reset() override {
    for (MagnetometerSensor& sensor : sensors_) sensor.reset();
  }

 private:
  std::list<MagnetometerSensor> sensors_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Magnetometer, "ignition::gazebo::systems::Magnetometer",
                      "gz::sim::systems::Magnetometer");
