#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "pongsim/bulk.hh"
#include "pongsim/declaration.hh"
#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace sim {
class SensorMetrics;
}  // namespace sim

/// Topic and schedule of a sensor: its topic, its rate in simulated time, and the service that changes the rate
/// (`TOPIC/set_rate`, ignition.msgs.Double). Several sensors may have the same topic; the first of them has the
/// service, and a warning says so. With `<enable_metrics>` it also publishes the actual rate
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
  // the callback of its service has its address
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
  /// @return TOPIC: the sensor's topic without `behind`.
  const std::string& name() const { return name_; }
  void reset();
  void transfer(StateArchive& archive);

 private:
  void setRate(double rate);

  std::string frameName_;
  std::string name_;
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
