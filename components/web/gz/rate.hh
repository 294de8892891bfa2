#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace pongsim::web::gz {

/// Lets a limited number of messages per second pass. The limit can be set from another thread.
class Rate {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param hz Positive; infinite: no limit.
  explicit Rate(double hz) { set(hz); }

  void set(double hz) { periodNs_ = static_cast<std::int64_t>(std::min(1e9 / hz, kLongestNs)); }

  /// @return Whether a message may pass. All pass if they arrive at the allowed rate, apart from jitter.
  bool passes(Clock::time_point now) {
    const std::chrono::nanoseconds period(periodNs_.load(std::memory_order_relaxed));
    // the limit may have been lower before
    next_ = std::min(next_, now + 2 * period);
    if (now + period / 2 < next_) return false;
    next_ = std::max(next_, now - period / 2) + period;
    return true;
  }

 private:
  // about 30 years
  static constexpr double kLongestNs = 1e18;

  std::atomic<std::int64_t> periodNs_ = 0;
  Clock::time_point next_{};
};

}  // namespace pongsim::web::gz
