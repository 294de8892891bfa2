#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// Progress of a run, as in `ignition.msgs.Clock` and `ignition.msgs.WorldStatistics`.
struct Status {
  Time simulated{0};
  /// Wall time spent running, without pauses.
  std::chrono::nanoseconds real{0};
  /// Wall-clock time since 1970.
  std::chrono::nanoseconds system{0};
  std::uint64_t iterations = 0;
  double realTimeFactor = 0;
  bool paused = false;
  /// Only in `ignition.msgs.WorldStatistics` that are part of a state.
  Time stepSize{0};
};

/// The two messages, reused.
class StatusMessages {
 public:
  StatusMessages();
  ~StatusMessages();

  /// @return `ignition.msgs.Clock`; valid until the next call.
  const Message& clock(const Status& status);
  /// @return `ignition.msgs.WorldStatistics`, with the real-time factor rounded to four decimals; valid until the next
  /// call.
  const Message& statistics(const Status& status);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// @return The content of an `ignition.msgs.WorldStatistics`.
Status statusOf(const Message& statistics);

/// @return The content of the statistics in an `ignition.msgs.SerializedStepMap`.
Status statusOfState(const Message& step);

/// Rates of a sensor for `ignition.msgs.PerformanceSensorMetrics` [1/s].
struct SensorRates {
  /// Readings per simulated second.
  double simulated = 0;
  /// Readings per second of wall time.
  double real = 0;
  /// The requested rate, per simulated second.
  double nominal = 0;
  /// Cameras only: mean number of images per second of wall time.
  std::optional<double> pictures = std::nullopt;
};

/// Each function fills in one part of an `ignition.msgs.PerformanceSensorMetrics`.
void setSensorName(const std::string& name, Message& performanceSensorMetrics);
void setRates(const SensorRates& rates, Message& performanceSensorMetrics);

}  // namespace pongsim::msgs
