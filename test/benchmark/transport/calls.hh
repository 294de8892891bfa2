#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace pongsim::benchmark {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

/// @return The duration that this part (0 to 1) of all does not exceed [us].
double quantile(std::vector<Microseconds> all, double part);

/// @return The durations' median, 99.9 % quantile and maximum, as text.
std::string summary(const std::vector<Microseconds>& all);

/// How long each of many calls took, and how many of them gave up the processor (`waits`) or lost it (`pushes`).
struct Calls {
  std::vector<Microseconds> took;
  int waits = 0;
  int pushes = 0;

  void measure(const std::function<void()>& call);
};

/// Calls `publish` at the rate [Hz], and `between` after each, half a period later.
Calls publishAt(double rate, int count, const std::function<void()>& publish,
                const std::function<void()>& between = {});

}  // namespace pongsim::benchmark
