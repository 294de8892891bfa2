#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

// What benchmarks of messages between processes share.

namespace pongsim::test {

/// Seconds of the steady clock, the same in all processes.
inline double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline double median(std::vector<double> all) {
  if (all.empty()) return 0;
  std::ranges::sort(all);
  return all[all.size() / 2];
}

/// Collects the ages of received messages. For any thread.
class MessageAges {
 public:
  void add(double age) {
    const std::lock_guard lock(mutex_);
    ages_.push_back(age);
    last_ = std::chrono::steady_clock::now();
  }
  /// Waits for this many, or until none has come for two seconds after the first.
  std::vector<double> wait(int count) {
    while (true) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const std::lock_guard lock(mutex_);
      const bool isSilent = !ages_.empty() && std::chrono::steady_clock::now() - last_ > std::chrono::seconds(2);
      if (static_cast<int>(ages_.size()) >= count || isSilent) return ages_;
    }
  }

 private:
  std::mutex mutex_;
  std::vector<double> ages_;
  std::chrono::steady_clock::time_point last_;
};

/// Calls a function `count` times, `rate` times per second.
inline void callAtRate(int count, double rate, const std::function<void()>& call) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (int i = 0; i < count; ++i) {
    std::this_thread::sleep_until(start +
                                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(i / rate)));
    call();
  }
}

/// Waits until the condition holds, without a time limit.
inline void waitFor(const std::function<bool()>& condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace pongsim::test
