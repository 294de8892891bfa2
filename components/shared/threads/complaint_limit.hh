#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

namespace pongsim::shared {

/// Lets one complaint per second through, so that bad messages do not flood the log.
class ComplaintLimit {
 public:
  /// @return Nothing if this complaint is suppressed; otherwise the number suppressed since the last one.
  std::optional<std::uint64_t> pass(std::chrono::steady_clock::time_point now) {
    if (last_ && now - *last_ < kPeriod) {
      ++keptBack_;
      return std::nullopt;
    }
    last_ = now;
    return std::exchange(keptBack_, 0);
  }

 private:
  static constexpr std::chrono::seconds kPeriod{1};

  std::optional<std::chrono::steady_clock::time_point> last_;
  std::uint64_t keptBack_ = 0;
};

}  // namespace pongsim::shared
