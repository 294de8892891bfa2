#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "pongsim/control/rolling_mean.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// Publishes a sensor's actual rates on `TOPIC/performance_metrics`. (Fortress computes the rate in simulated time
/// wrongly, dividing by nanoseconds, and leaves out cameras' `fps_optional`.)
class SensorMetrics {
 public:
  /// @param topic The sensor's topic.
  SensorMetrics(const Sensor& sensor, const std::string& topic, Node& node);

  bool hasSubscribers() const { return publisher_.hasSubscribers(); }

  /// Call it with each published reading.
  /// @param nominalRate Current rate, readings per simulated second; zero: one per step.
  void publish(Time now, double nominalRate);

  /// Discards what was measured.
  void reset();

 private:
  using Clock = std::chrono::steady_clock;
  struct Moment {
    Time simulated;
    Clock::time_point real;
  };
  /// A camera's rate is the mean over this many images.
  static constexpr std::size_t kPictures = 30;

  bool isCamera_;
  MessagePointer message_;
  Publisher publisher_;
  std::optional<Moment> last_;
  RollingMean<kPictures> realPeriods_;
};

}  // namespace pongsim::sim
