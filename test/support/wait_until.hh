#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "support/process.hh"

namespace pongsim::test {

/// Waits until that is true.
/// @return Whether it is; false after the tests' deadline.
inline bool waitUntil(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace pongsim::test
