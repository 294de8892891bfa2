#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

namespace pongsim::transport {

/// Lets one complaint a second through, so that a flood of bad messages is no flood of words.
class ComplaintLimit {
 public:
  /// @return Nothing where this complaint is to be kept back; else how many were since the last one.
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

}  // namespace pongsim::transport
