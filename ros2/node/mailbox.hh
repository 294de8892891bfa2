#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace pongsim::ros2 {

/// What waits for the simulation's thread. Any thread may post; one dispatches.
class Mailbox {
 public:
  explicit Mailbox(std::size_t most = 1000) : most_(most) {}

  /// @param posted Called by who posts, behind each call that will be done. To be set before anybody posts.
  void whenPosted(std::function<void()> posted) { posted_ = std::move(posted); }

  /// @return Whether it will be done; not, and it is counted, where too much waits already.
  bool post(std::function<void()> call);

  /// Does what waits, in order; cheap where nothing does.
  /// @return How much it was.
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
