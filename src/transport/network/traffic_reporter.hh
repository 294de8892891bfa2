#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <thread>

#include "transport/locks.hh"
#include "transport/network/traffic_report.hh"

namespace pongsim::transport {

class Writer;

/// Reports the traffic of this participant's publishers and subscriptions to others, ten times per second while one of
/// them has a reader of `kTrafficTopic`. It uses no resources before that.
class TrafficReporter {
 public:
  // Not a topic name, since it has no leading slash.
  static constexpr const char* kTrafficTopic = "pongsim/traffic";
  static constexpr const char* kTrafficType = "pongsim.Traffic";

  /// @param makeWriter Makes the topic's writer, which calls its argument when a reader is added or removed.
  explicit TrafficReporter(std::function<std::unique_ptr<Writer>(std::function<void()> readersChanged)> makeWriter);
  ~TrafficReporter();
  TrafficReporter(const TrafficReporter&) = delete;
  TrafficReporter& operator=(const TrafficReporter&) = delete;

  /// @param source Called on the reporter's own thread; the previous one is not called any more when this returns.
  void setSource(std::function<TrafficReport()> source);

  /// Handles a request. Returns at once; thread-safe.
  void ask();

  /// Ends reporting.
  void stop();

 private:
  void run();
  void answer();
  void report(Writer& writer);

  std::function<std::unique_ptr<Writer>(std::function<void()>)> makeWriter_;
  /// Held while the source is called.
  Mutex sourceMutex_;
  std::function<TrafficReport()> source_ GUARDED_BY(sourceMutex_);
  Mutex mutex_;
  std::condition_variable changed_;
  bool isAsked_ GUARDED_BY(mutex_) = false;
  bool haveReadersChanged_ GUARDED_BY(mutex_) = false;
  bool isOver_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace pongsim::transport
