#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace pongsim::transport {

/// A token bucket: holds at most `capacity` tokens, is full at first, and gains `perSecond` tokens per second.
class TokenBucket {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  TokenBucket(double capacity, double perSecond) : capacity_(capacity), perSecond_(perSecond), tokens_(capacity) {}

  /// @return Whether that many tokens were available; if so, they have been removed.
  bool take(double amount, TimePoint now) {
    if (last_) {
      tokens_ = std::min(capacity_, tokens_ + perSecond_ * std::chrono::duration<double>(now - *last_).count());
    }
    last_ = now;
    if (amount > tokens_) return false;
    tokens_ -= amount;
    return true;
  }

 private:
  double capacity_, perSecond_, tokens_;
  std::optional<TimePoint> last_;
};

}  // namespace pongsim::transport
