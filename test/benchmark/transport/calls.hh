#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace pongsim::benchmark {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

/// @param part 0 to 1.
/// @return The quantile of the durations [us].
double quantile(std::vector<Microseconds> all, double part);

/// @return The durations' median, 99.9 % quantile and maximum, as text.
std::string summary(const std::vector<Microseconds>& all);

/// Durations of many calls, and how often the thread gave up the processor (`waits`) or was preempted (`pushes`).
struct Calls {
  std::vector<Microseconds> took;
  int waits = 0;
  int pushes = 0;

  void measure(const std::function<void()>& call);
};

/// Calls `publish` at the rate [Hz], and `between` half a period after each call.
Calls publishAt(double rate, int count, const std::function<void()>& publish,
                const std::function<void()>& between = {});

}  // namespace pongsim::benchmark
