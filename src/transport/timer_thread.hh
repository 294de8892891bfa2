#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <thread>

#include "transport/locks.hh"

namespace pongsim::transport {

/// A thread that calls a function again and again, at the times that it returns, until it is destroyed.
class TimerThread {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// @param task Returns the time of its next call; after a std::bad_alloc it is called again in a second.
  /// @throws std::system_error if the thread can't be started.
  explicit TimerThread(std::function<TimePoint()> task);
  /// `task` is not called from then on.
  ~TimerThread();
  TimerThread(const TimerThread&) = delete;
  TimerThread& operator=(const TimerThread&) = delete;

 private:
  void run();

  std::function<TimePoint()> task_;
  Mutex mutex_;
  std::condition_variable changed_;
  bool mustEnd_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace pongsim::transport
