#pragma once

#include <chrono>
#include <string>

#include "msgs/control/status_messages.hh"
#include "pongsim/node.hh"

namespace pongsim::sim {

/// Publishes the status of a run on `/world/W/clock` (each step) and `/world/W/stats` (10 Hz), and for the first world
/// of a process also on `/clock` and `/stats` (each step).
class StatusPublisher {
 public:
  StatusPublisher(Transport& transport, const std::string& worldName, bool isFirst);

  /// Publishes the status; almost free without subscribers.
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
