#pragma once

#include <ignition/msgs/time.pb.h>

#include <algorithm>
#include <cstdint>

#include "pongsim/types.hh"

namespace pongsim::msgs {

/// @return The time as far as it fits in nanoseconds, from -146 to 146 years.
inline Time timeOf(const ignition::msgs::Time& message) {
  constexpr std::int64_t kLargest = 146LL * 365 * 86400;
  return std::chrono::seconds(std::clamp<std::int64_t>(message.sec(), -kLargest, kLargest)) +
         std::chrono::nanoseconds(message.nsec());
}

inline void setTime(Time time, ignition::msgs::Time& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  message.set_sec(seconds.count());
  message.set_nsec(static_cast<std::int32_t>((time - seconds).count()));
}

}  // namespace pongsim::msgs
