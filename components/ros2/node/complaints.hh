#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "pongsim/log.hh"

namespace pongsim::ros2 {

/// Lets one warning a second pass, so that a flood of bad messages does not become a flood of warnings. Any thread may
/// use it.
class Complaints {
 public:
  void warn(const Logger& log, std::string_view what) {
    std::uint64_t before = 0;
    {
      const std::lock_guard lock(mutex_);
      const auto now = std::chrono::steady_clock::now();
      if (last_ && now - *last_ < std::chrono::seconds(1)) {
        ++keptBack_;
        return;
      }
      last_ = now;
      before = std::exchange(keptBack_, 0);
    }
    log.warning(std::string(what) + (before > 0 ? " (and " + std::to_string(before) + " before it)" : ""));
  }

 private:
  std::mutex mutex_;
  std::optional<std::chrono::steady_clock::time_point> last_;
  std::uint64_t keptBack_ = 0;
};

}  // namespace pongsim::ros2
