#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "support/process.hh"

namespace pongsim::test {

/// Waits until the condition holds.
/// @return False if it does not hold within `kDeadline`.
inline bool waitUntil(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace pongsim::test
