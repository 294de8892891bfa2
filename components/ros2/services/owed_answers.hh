#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>

namespace pongsim::ros2 {

/// Pending answers to requests that are completed later. A reset of the world may drop the requests, but every caller
/// gets an answer.
class OwedAnswers {
 public:
  /// @param forgotten Called if it will never be completed.
  /// @return Its number, for `settle`.
  std::uint64_t owe(std::function<void()> forgotten) {
    owed_.emplace(next_, std::move(forgotten));
    return next_++;
  }

  /// Call on completion.
  /// @return Whether the answer is still pending.
  bool settle(std::uint64_t number) { return owed_.erase(number) > 0; }

  /// Call after a reset of the world: calls all functions.
  void forget() {
    const auto owed = std::exchange(owed_, {});
    for (const auto& [number, forgotten] : owed) forgotten();
  }

 private:
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::function<void()>> owed_;
};

}  // namespace pongsim::ros2
