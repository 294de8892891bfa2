#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace pongsim::cli {

/// Handles SIGINT and SIGTERM as requests to stop; a second one ends the process, however long stopping takes. Create
/// it before other threads: they inherit that the two signals are blocked, so that this object's own thread gets them.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// @return Whether such a signal has arrived.
  bool stopped() const { return stopped_; }

  /// Calls a function when a signal arrives, on another thread, or immediately if one has arrived already, until this
  /// object is destroyed. Declare it after everything that the function uses: it then never calls into what has been
  /// destroyed, also if the work throws. One at a time.
  class Callback {
   public:
    Callback(StopSignal& signal, std::function<void()> notify);
    /// Waits for a call that is in progress.
    ~Callback();
    Callback(const Callback&) = delete;
    Callback& operator=(const Callback&) = delete;

   private:
    StopSignal& signal_;
  };

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
