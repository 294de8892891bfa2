#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// Where a run stands, as `ignition.msgs.Clock` and `ignition.msgs.WorldStatistics` tell it.
struct Status {
  Time simulated{0};
  /// Wall time spent running, pauses apart.
  std::chrono::nanoseconds real{0};
  /// Wall-clock time since 1970.
  std::chrono::nanoseconds system{0};
  std::uint64_t iterations = 0;
  double realTimeFactor = 0;
  bool paused = false;
  /// Of `ignition.msgs.WorldStatistics` that come with a state.
  Time stepSize{0};
};

/// The two messages, used again and again.
class StatusMessages {
 public:
  StatusMessages();
  ~StatusMessages();

  /// @return `ignition.msgs.Clock`; lives until the next call.
  const Message& clock(const Status& status);
  /// @return `ignition.msgs.WorldStatistics`, the factor rounded to four decimals; lives until the next call.
  const Message& statistics(const Status& status);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// @return What an `ignition.msgs.WorldStatistics` tells.
Status statusOf(const Message& statistics);

/// @return What the statistics in an `ignition.msgs.SerializedStepMap` tell.
Status statusOfState(const Message& step);

/// How often a sensor speaks, as `ignition.msgs.PerformanceSensorMetrics` tells it; all a second.
struct SensorRates {
  /// Readings in simulated time.
  double simulated = 0;
  /// Readings in wall time.
  double real = 0;
  /// What is asked for, in simulated time.
  double nominal = 0;
  /// Of a camera, pictures in wall time, a mean.
  std::optional<double> pictures = std::nullopt;
};

/// Each fills in that part of an `ignition.msgs.PerformanceSensorMetrics`.
void setSensorName(const std::string& name, Message& performanceSensorMetrics);
void setRates(const SensorRates& rates, Message& performanceSensorMetrics);

}  // namespace pongsim::msgs
