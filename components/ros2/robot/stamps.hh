#pragma once

#include <chrono>

#include "pongsim/types.hh"
#include "ros2/pairs/frames.hh"
#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2 {

/// @return The stamp for this simulated time; wall time if the user wants that.
inline builtin_interfaces::Time stampOf(Time now, const Frames& frames) {
  std::chrono::nanoseconds time = now;
  if (frames.usesWallTime) time = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  return {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((time - seconds).count())};
}

}  // namespace pongsim::ros2
