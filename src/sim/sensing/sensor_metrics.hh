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

/// Publishes a sensor's actual rates on `TOPIC/performance_metrics`. Unlike this, Fortress divides by nanoseconds to
/// get the rate in simulated time, and leaves out `fps_optional` of cameras.
class SensorMetrics {
 public:
  /// @param topic The sensor's topic.
  SensorMetrics(const Sensor& sensor, const std::string& topic, Node& node);

  bool hasSubscribers() const { return publisher_.hasSubscribers(); }

  /// To be called with each published reading.
  /// @param nominalRate Current rate [readings per simulated second]; zero: one per step.
  void publish(Time now, double nominalRate);

  /// Discards the measured periods.
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
