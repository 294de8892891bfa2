#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace pongsim::ros2 {

/// Work queued for the simulation's thread. Any thread may post; one dispatches.
class Mailbox {
 public:
  explicit Mailbox(std::size_t most = 1000) : most_(most) {}

  /// @param posted Called by the posting thread after each accepted call. Set it before anybody posts.
  void whenPosted(std::function<void()> posted) { posted_ = std::move(posted); }

  /// @return Whether it is queued; if the queue is full, it is dropped and counted.
  bool post(std::function<void()> call);

  /// Runs the queued calls in order; cheap if there are none.
  /// @return The number of calls.
  std::size_t dispatch();

  std::uint64_t dropped() const { return dropped_; }

 private:
  const std::size_t most_;
  std::function<void()> posted_;
  std::mutex mutex_;
  std::vector<std::function<void()>> waiting_;
  std::vector<std::function<void()>> taken_;
  std::atomic<bool> isWaiting_ = false;
  std::atomic<std::uint64_t> dropped_ = 0;
};

}  // namespace pongsim::ros2
