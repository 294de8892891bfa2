#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// The request in an `ignition.msgs.WorldReset`.
enum class Reset { kNone, kAll, kTimeOnly, kModelsOnly };

/// The request in an `ignition.msgs.WorldControl`.
struct WorldControl {
  bool pause = false;
  /// Number of steps to run before pausing; 0: not requested.
  std::uint32_t steps = 0;
  /// Simulated time at which to pause.
  std::optional<Time> runTo = std::nullopt;
  Reset reset = Reset::kNone;
  /// New seed; 0: none.
  std::uint32_t seed = 0;
};

/// The request in an `ignition.msgs.LogPlaybackControl`.
struct PlaybackControl {
  /// Its `pause` and `multi_step`.
  WorldControl run;
  bool rewind = false;
  bool forward = false;
  /// Simulated time to jump to.
  std::optional<Time> seek = std::nullopt;
};

/// The request in an `ignition.msgs.ServerControl`.
struct ServerControl {
  bool stop = false;
  /// Whether it contains other requests too.
  bool more = false;
};

/// Each function reads or fills in a message of the type in its name.
WorldControl worldControl(const Message& message);
PlaybackControl playbackControl(const Message& message);
ServerControl serverControl(const Message& message);
void setBoolean(bool value, Message& message);
void setLogPlaybackStatistics(Time start, Time end, Message& message);
void addString(const std::string& value, Message& stringMsgV);
std::vector<std::string> strings(const Message& stringMsgV);
void setString(const std::string& value, Message& stringMsg);
std::string string(const Message& stringMsg);

/// @return An `ignition.msgs.WorldControl` with these requests; the only reset it supports is that of everything.
MessagePointer worldControlMessage(const WorldControl& control);
/// @return The value of an `ignition.msgs.Boolean`.
bool boolean(const Message& message);
/// @return The value of an `ignition.msgs.Double`.
double number(const Message& message);
/// @return `ignition.msgs.Int32`.
MessagePointer int32Message(std::int32_t value);

}  // namespace pongsim::msgs
