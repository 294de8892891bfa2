#pragma once

#include <chrono>
#include <string>

#include "msgs/status_messages.hh"
#include "pongsim/node.hh"

namespace pongsim::sim {

/// Tells where a run stands on `/world/W/clock` (each step) and `/world/W/stats` (10 Hz), and the first one of a
/// process on `/clock` and `/stats` (each step), too.
class StatusPublisher {
 public:
  StatusPublisher(Transport& transport, const std::string& worldName, bool isFirst);

  /// Publishes to whoever listens; costs next to nothing where nobody does.
  void publish(const msgs::Status& status, std::chrono::steady_clock::time_point now);

 private:
  static constexpr std::chrono::milliseconds kWorldStatisticsPeriod{100};

  msgs::StatusMessages messages_;
  Publisher clock_;
  Publisher statistics_;
  Publisher worldClock_;
  Publisher worldStatistics_;
  std::chrono::steady_clock::time_point nextWorldStatistics_;
};

}  // namespace pongsim::sim
