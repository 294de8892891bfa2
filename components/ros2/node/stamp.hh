#pragma once

#include <chrono>

#include "pongsim/types.hh"
#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2 {

/// @return A simulated time as a ROS message.
inline builtin_interfaces::Time stampOf(Time time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  return {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((time - seconds).count())};
}

/// @param stamp A builtin_interfaces/Time or Duration.
template <class Stamp>
Time timeOf(const Stamp& stamp) {
  return std::chrono::seconds(stamp.sec) + Time(stamp.nanosec);
}

}  // namespace pongsim::ros2
