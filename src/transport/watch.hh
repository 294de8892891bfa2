#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <thread>

#include "transport/locks.hh"

namespace pongsim::transport {

/// A thread that looks after something, again and again, until it is destroyed.
class Watch {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param look Returns when it is to be called next. What it throws for want of memory lets it be called again in a
  /// second.
  /// @throws std::system_error where the system gives no thread.
  explicit Watch(std::function<TimePoint()> look);
  /// `look` is not called from then on.
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  void run();

  std::function<TimePoint()> look_;
  Mutex mutex_;
  std::condition_variable changed_;
  bool isOver_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace pongsim::transport
