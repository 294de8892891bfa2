#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "transport/traffic_report.hh"

namespace pongsim::transport {

class Writer;

/// Tells other participants, ten times a second while one of them asks, what has passed through this one's publishers
/// and subscriptions. Whoever has a reader of `kTrafficTopic` asks. Nothing of it is there before somebody does.
class TrafficReporter {
 public:
  // no topic's name, for it has no leading slash
  static constexpr const char* kTrafficTopic = "pongsim/traffic";
  static constexpr const char* kTrafficType = "pongsim.Traffic";

  /// @param makeWriter Makes the topic's writer, which calls its argument when a reader comes or goes.
  explicit TrafficReporter(std::function<std::unique_ptr<Writer>(std::function<void()> readersChanged)> makeWriter);
  ~TrafficReporter();
  TrafficReporter(const TrafficReporter&) = delete;
  TrafficReporter& operator=(const TrafficReporter&) = delete;

  /// @param source Called from a thread of the reporter's own, and from this call's return on the one before no more.
  void setSource(std::function<TrafficReport()> source);

  /// Somebody asks. Returns at once; any thread may call it.
  void ask();

  /// Ends all of it.
  void stop();

 private:
  void run();
  void answer();
  void report(Writer& writer);

  std::function<std::unique_ptr<Writer>(std::function<void()>)> makeWriter_;
  std::mutex sourceMutex_;
  std::function<TrafficReport()> source_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isAsked_ = false;
  bool haveReadersChanged_ = false;
  bool isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::transport
