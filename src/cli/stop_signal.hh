#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace pongsim::cli {

/// Takes SIGINT and SIGTERM as a wish to end. Make it before other threads: they inherit that the two signals are
/// blocked, so that this object's own thread gets them.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// @return Whether one has come.
  bool stopped() const { return stopped_; }

  /// Calls `notify` when one comes, on another thread, or at once where one has come; an empty function ends that.
  /// A second signal ends the process, however long the work takes to stop.
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
