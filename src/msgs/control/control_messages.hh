#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// What `ignition.msgs.WorldReset` asks for.
enum class Reset { kNone, kAll, kTimeOnly, kModelsOnly };

/// What `ignition.msgs.WorldControl` asks for.
struct WorldControl {
  bool pause = false;
  /// So many steps, then a pause; 0: nothing of the kind.
  std::uint32_t steps = 0;
  /// Pause at that simulated time.
  std::optional<Time> runTo = std::nullopt;
  Reset reset = Reset::kNone;
  /// New seed; 0: none.
  std::uint32_t seed = 0;
};

/// What `ignition.msgs.LogPlaybackControl` asks for.
struct PlaybackControl {
  /// Its `pause` and `multi_step`.
  WorldControl run;
  bool rewind = false;
  bool forward = false;
  /// To that simulated time.
  std::optional<Time> seek = std::nullopt;
};

/// What `ignition.msgs.ServerControl` asks for.
struct ServerControl {
  bool stop = false;
  /// Whether it asks for something else too.
  bool more = false;
};

/// Each reads or fills in a message of the type that its name tells.
WorldControl worldControl(const Message& message);
PlaybackControl playbackControl(const Message& message);
ServerControl serverControl(const Message& message);
void setBoolean(bool value, Message& message);
void addString(const std::string& value, Message& stringMsgV);
std::vector<std::string> strings(const Message& stringMsgV);
void setString(const std::string& value, Message& stringMsg);
std::string string(const Message& stringMsg);

/// @return `ignition.msgs.WorldControl` that asks for that; of resets that of all.
MessagePointer worldControlMessage(const WorldControl& control);
/// @return The value of an `ignition.msgs.Boolean`.
bool boolean(const Message& message);
/// @return The value of an `ignition.msgs.Double`.
double number(const Message& message);
/// @return `ignition.msgs.Int32`.
MessagePointer int32Message(std::int32_t value);

}  // namespace pongsim::msgs
