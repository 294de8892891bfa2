#include <ignition/msgs/altimeter.pb.h>

#include <list>
#include <string>

#include "pongsim/fields.hh"
#include "pongsim/noise.hh"
#include "pongsim/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// One sensor: what it measures, and where it speaks.
class AltimeterSensor {
 public:
  AltimeterSensor(const Sensor& sensor, const World&, Node& node, Random random)
      : sensor_(sensor),
        topic_(sensor, "/altimeter", "ignition.msgs.Altimeter", node),
        positionNoise_(sensor.settings<AltimeterSettings>()->verticalPosition, random.split("position")),
        velocityNoise_(sensor.settings<AltimeterSettings>()->verticalVelocity, random.split("velocity")),
        reference_(sensor.pose().position.z()) {
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
    message_.set_vertical_reference(reference_);
    message_.set_vertical_position(positionNoise_.apply(sensor_.pose().position.z() - reference_, dt));
    message_.set_vertical_velocity(velocityNoise_.apply(sensor_.linearVelocity().z(), dt));
  }

  Sensor sensor_;
  SensorTopic topic_;
  Noise positionNoise_;
  Noise velocityNoise_;
  /// Height at the start [m].
  double reference_;
  ignition::msgs::Altimeter message_;
};

/// Publishes how high the world's altimeters are above their start, and how fast they climb.
class Altimeter : public System {
 public:
  void configure(const SystemContext& context) override {
    for (const Sensor& sensor : context.world.sensors("altimeter")) {
      sensors_.emplace_back(sensor, context.world, context.node, context.random.split(sensor.scopedName()));
    }
  }

  void postUpdate(const StepInfo& info) override {
    for (AltimeterSensor& sensor : sensors_) sensor.update(info);
  }

  void reset() override {
    for (AltimeterSensor& sensor : sensors_) sensor.reset();
  }

 private:
  std::list<AltimeterSensor> sensors_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Altimeter, "ignition::gazebo::systems::Altimeter", "gz::sim::systems::Altimeter");
