#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/rolling_mean.hh"
#include "pongsim/sensor.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// How often a sensor speaks, on `TOPIC/performance_metrics`. (Fortress divides by nanoseconds for the rate in
/// simulated time, and leaves cameras' `fps_optional` out.)
class SensorMetrics {
 public:
  /// @param topic Of the sensor.
  SensorMetrics(const Sensor& sensor, const std::string& topic, Node& node);

  bool hasSubscribers() const { return publisher_.hasSubscribers(); }

  /// Call it with each reading that is published.
  /// @param nominalRate Readings a simulated second as they are asked for now, zero: one every step.
  void publish(Time now, double nominalRate);

  /// Forgets what was published.
  void reset();

 private:
  using Clock = std::chrono::steady_clock;
  struct Moment {
    Time simulated;
    Clock::time_point real;
  };
  /// A camera's pictures a second are the mean of so many.
  static constexpr std::size_t kPictures = 30;

  bool isCamera_;
  MessagePointer message_;
  Publisher publisher_;
  std::optional<Moment> last_;
  RollingMean<kPictures> realPeriods_;
};

}  // namespace pongsim::sim
