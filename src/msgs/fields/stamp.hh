#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @return The time as far as it fits in nanoseconds, from -146 to 146 years.
Time timeOf(std::int64_t seconds, std::int64_t nanoseconds);

/// @param type Full name of a message type.
/// @return Whether its messages have a header that can tell a time.
bool hasStamp(std::string_view type);

/// @return The time in the message's header; nothing where it has none.
std::optional<Time> stampOf(const Message& message);

/// Simulated and wall time at the end of the same step, as an `ignition.msgs.Clock` tells them.
struct ClockReading {
  Time simulated{0};
  /// Since 1970.
  Time system{0};
};

/// @param clock An `ignition.msgs.Clock`.
ClockReading clockReading(const Message& clock);

}  // namespace pongsim::msgs
