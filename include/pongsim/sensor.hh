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
#include "pongsim/sensor_settings.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace sim {
class SensorMetrics;
}  // namespace sim

/// A way to one `<sensor>` of a running world. A copy is the same sensor; it must not outlive its `Simulation`.
class PONGSIM_API Sensor {
 public:
  SensorId id() const { return id_; }
  /// @return Whether it is still there. If not, all other functions but `id` and `isSetAside` throw `Gone`.
  bool exists() const;
  /// @return Whether it is not there because its model is set aside (`Model::isSetAside`): it comes back.
  bool isSetAside() const;
  std::string_view name() const;
  /// @return Its type as the file has it: "imu".
  std::string_view type() const;
  /// @return Its name with all that holds it but the world: "model::link::sensor".
  std::string scopedName() const;
  /// @return The link that bears it; for a sensor on a joint the joint's child.
  Link link() const;
  /// @return The joint that holds it; nothing for a sensor on a link.
  std::optional<Joint> joint() const;
  /// @return Pose of the sensor frame in the frame of `link()`; never changes.
  Pose poseInLink() const;
  /// @return Pose of the sensor frame in the world frame.
  Pose pose() const;
  /// @return Velocity of the sensor frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;
  /// @return Messages a simulated second that the file asks for; zero: one every step.
  double updateRate() const;
  bool isAlwaysOn() const;
  /// @return Whether the file asks for `SensorTopic`'s metrics.
  bool hasMetrics() const;
  /// @return What the file says in `<topic>`, else "/world/W/model/M/link/L/sensor/S" and `suffix`, which begins with
  /// a slash.
  std::string topic(std::string_view suffix) const;
  /// @return Name of its frame in messages: `<ignition_frame_id>`, else `scopedName()`.
  std::string frameName() const;
  /// @return What the element of its own type says, as `settings<ImuSettings>()`; null for a sensor of another type.
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

/// Where a sensor speaks and when: its topic, its rate in simulated time, the service that changes the rate
/// (`TOPIC/set_rate`, ignition.msgs.Double). Of a sensor with `<enable_metrics>` it also tells how often it really
/// speaks (`TOPIC/performance_metrics`, ignition.msgs.PerformanceSensorMetrics, with each reading from the second on).
class PONGSIM_API SensorTopic {
 public:
  /// @param suffix See `Sensor::topic`.
  /// @param type Of the messages.
  /// @param behind Behind the topic is where they are published, as "/image".
  /// @throws Error naming the sensor's place where its topic can't be one.
  SensorTopic(const Sensor& sensor, std::string_view suffix, std::string_view type, Node& node,
              std::string_view behind = {});
  ~SensorTopic();
  // services hold on to it
  SensorTopic(const SensorTopic&) = delete;
  SensorTopic& operator=(const SensorTopic&) = delete;

  /// Declares what each sensor has beside its messages.
  static void declare(Declaration& declaration);

  /// Call it in each `postUpdate`.
  /// @return Whether a reading is due in this step. As in Fortress, the time between two is cut off to whole
  /// milliseconds, and none is due while paused.
  bool isDue(const StepInfo& info);
  /// @return Whether somebody listens, to the metrics too, so that the reading that is due is to be published.
  bool hasSubscribers() const;
  /// Publishes the reading that was due last.
  void publish(const Message& message);
  /// Likewise one whose bulk is elsewhere (`Publisher::publish`).
  void publish(const Message& message, const Bulk& bulk);

  /// @return Time between the last two readings that were due [s], zero for the first one: what `Noise` asks for.
  double sinceLast() const { return sinceLast_; }
  /// @return Readings that were due before the last one, whether or not somebody listened.
  std::uint64_t sequence() const { return count_ - 1; }
  const std::string& frameName() const { return frameName_; }
  void reset();
  void transfer(StateArchive& archive);

 private:
  void setRate(double rate);

  std::string frameName_;
  /// Largest rate, zero: not limited.
  double largestRate_;
  /// As it is now, zero: one every step.
  double rate_;
  Time period_{0};
  Time due_{0};
  Time now_{0};
  Time last_{0};
  double sinceLast_ = 0;
  std::uint64_t count_ = 0;
  Publisher publisher_;
  Service rateService_;
  /// Null where the file asks for none.
  std::unique_ptr<sim::SensorMetrics> metrics_;
};

}  // namespace pongsim
