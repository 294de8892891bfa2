#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>

namespace pongsim::ros2 {

/// Answers that wait for what is done later, and which a reset of the world may forget: nobody who asks is left without
/// one.
class OwedAnswers {
 public:
  /// @param forgotten Called where it will never be done.
  /// @return Its number, for `settle`.
  std::uint64_t owe(std::function<void()> forgotten) {
    owed_.emplace(next_, std::move(forgotten));
    return next_++;
  }

  /// To be called when it is done.
  /// @return Whether the answer is owed still.
  bool settle(std::uint64_t number) { return owed_.erase(number) > 0; }

  /// The world was reset: calls all functions.
  void forget() {
    const auto owed = std::exchange(owed_, {});
    for (const auto& [number, forgotten] : owed) forgotten();
  }

 private:
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::function<void()>> owed_;
};

}  // namespace pongsim::ros2
