#pragma once

#include <algorithm>
#include <chrono>

namespace pongsim::transport {

using TimePoint = std::chrono::steady_clock::time_point;

/// @return Now plus the timeout; one too long to be added counts as a year.
inline TimePoint deadlineAfter(std::chrono::nanoseconds timeout) {
  return std::chrono::steady_clock::now() + std::min<std::chrono::nanoseconds>(timeout, std::chrono::hours(24 * 365));
}

}  // namespace pongsim::transport
