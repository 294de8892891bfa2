#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @return The time, clamped to what fits in nanoseconds: -146 to 146 years.
Time timeOf(std::int64_t seconds, std::int64_t nanoseconds);

/// @param type Full name of a message type.
/// @return Whether its messages have a header with a time stamp.
bool hasStamp(std::string_view type);

/// @return The time stamp in the message's header; nothing if it has none.
std::optional<Time> stampOf(const Message& message);

/// Simulated and wall time at the end of the same step, from an `ignition.msgs.Clock`.
struct ClockReading {
  Time simulated{0};
  /// Since 1970.
  Time system{0};
};

/// @param clock An `ignition.msgs.Clock`.
ClockReading clockReading(const Message& clock);

}  // namespace pongsim::msgs
