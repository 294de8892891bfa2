#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace pongsim::cli {

/// Handles SIGINT and SIGTERM as requests to stop. Create it before other threads: they inherit that the two signals
/// are blocked, so that this object's own thread gets them.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// @return Whether such a signal has arrived.
  bool stopped() const { return stopped_; }

  /// Calls `notify` when a signal arrives, on another thread, or immediately if one has arrived already; an empty
  /// function cancels this. A second signal ends the process, however long the work takes to stop.
  void onStop(std::function<void()> notify);

 private:
  void watch();

  int signals_ = -1;
  int end_ = -1;
  std::mutex mutex_;
  std::function<void()> notify_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace pongsim::cli
