#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/sensor_settings.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace sim {
class SensorMetrics;
}  // namespace sim

/// Handle to a `<sensor>` of a running world. Copies refer to the same sensor. Must not outlive its `Simulation`.
class PONGSIM_API Sensor {
 public:
  SensorId id() const { return id_; }
  /// @return Whether it exists. If not, all other functions but `id` and `isSetAside` throw `Gone`.
  bool exists() const;
  /// @return Whether its model is in an unloaded level (`Model::isSetAside`).
  bool isSetAside() const;
  std::string_view name() const;
  /// @return Its type as in the file: "imu".
  std::string_view type() const;
  /// @return Its name with all its parents but the world: "model::link::sensor".
  std::string scopedName() const;
  /// @return Its link; for a sensor on a joint, the joint's child.
  Link link() const;
  /// @return Its joint; nothing for a sensor on a link.
  std::optional<Joint> joint() const;
  /// @return Pose of the sensor frame in the frame of `link()`; constant.
  Pose poseInLink() const;
  /// @return Pose of the sensor frame in the world frame.
  Pose pose() const;
  /// @return Velocity of the sensor frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;
  /// @return Messages per simulated second, as in the file; zero: one per step.
  double updateRate() const;
  bool isAlwaysOn() const;
  /// @return Whether the file enables `SensorTopic`'s metrics.
  bool hasMetrics() const;
  /// @return `<topic>` of the file, else "/world/W/model/M/link/L/sensor/S" and `suffix`, which begins with a slash.
  std::string topic(std::string_view suffix) const;
  /// @return Its frame name in messages: `<ignition_frame_id>`, else `scopedName()`.
  std::string frameName() const;
  /// @return The settings of its type, such as `settings<ImuSettings>()`; null for a sensor of another type.
  template <class Settings>
  const Settings* settings() const {
    return std::get_if<Settings>(&allSettings());
  }
  /// @return The whole `<sensor>` element.
  const Element& sdf() const;

 private:
  friend class Link;
  friend class Joint;
  friend class World;
  Sensor(sim::Access& access, SensorId id) : access_(&access), id_(id) {}
  const SensorSettings& allSettings() const;
  sim::Access* access_;
  SensorId id_;
};

/// Topic and schedule of a sensor: its topic, its rate in simulated time, and the service that changes the rate
/// (`TOPIC/set_rate`, ignition.msgs.Double). With `<enable_metrics>` it also publishes the actual rate
/// (`TOPIC/performance_metrics`, ignition.msgs.PerformanceSensorMetrics, with each reading from the second on).
class PONGSIM_API SensorTopic {
 public:
  /// @param suffix See `Sensor::topic`.
  /// @param type Of the messages.
  /// @param behind Appended to the topic, such as "/image".
  /// @throws Error with the sensor's position if its topic is invalid.
  SensorTopic(const Sensor& sensor, std::string_view suffix, std::string_view type, Node& node,
              std::string_view behind = {});
  ~SensorTopic();
  // services hold on to it
  SensorTopic(const SensorTopic&) = delete;
  SensorTopic& operator=(const SensorTopic&) = delete;

  /// Declares the topics and services of each sensor beside its messages.
  static void declare(Declaration& declaration);

  /// Call it in each `postUpdate`.
  /// @return Whether a reading is due in this step. As in Fortress, the period is truncated to whole milliseconds, and
  /// none is due while paused.
  bool isDue(const StepInfo& info);
  /// @return Whether the reading or the metrics have subscribers, so that a due reading must be published.
  bool hasSubscribers() const;
  /// Publishes the reading that was due last.
  void publish(const Message& message);
  /// The same for a message with its bulk kept outside (`Publisher::publish`).
  void publish(const Message& message, const Bulk& bulk);

  /// @return Time between the last two due readings [s], zero for the first one: the argument of `Noise::begin`.
  double sinceLast() const { return sinceLast_; }
  /// @return The number of due readings before the last one, with or without subscribers.
  std::uint64_t sequence() const { return count_ - 1; }
  const std::string& frameName() const { return frameName_; }
  void reset();
  void transfer(StateArchive& archive);

 private:
  void setRate(double rate);

  std::string frameName_;
  /// Rate limit; zero: none.
  double largestRate_;
  /// Current rate; zero: one reading per step.
  double rate_;
  Time period_{0};
  Time due_{0};
  Time now_{0};
  Time last_{0};
  double sinceLast_ = 0;
  std::uint64_t count_ = 0;
  Publisher publisher_;
  Service rateService_;
  /// Null if the file does not enable them.
  std::unique_ptr<sim::SensorMetrics> metrics_;
};

}  // namespace pongsim
