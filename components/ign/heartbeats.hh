#pragma once

#include <chrono>
#include <map>
#include <string>

namespace pongsim::ign {

/// Tracks which other processes still announce themselves, as all do once a second. The library itself counts killed
/// processes as subscribers for ever. For one thread at a time.
class Heartbeats {
 public:
  using Clock = std::chrono::steady_clock;

  /// Listens on the same port as this process's discovery.
  /// @param address The address at which this process uses ign-transport.
  explicit Heartbeats(const std::string& address);
  ~Heartbeats();
  Heartbeats(const Heartbeats&) = delete;
  Heartbeats& operator=(const Heartbeats&) = delete;

  /// Reads what has arrived. Never blocks.
  void read();

  /// @return Whether a process with this id was heard in the last 10 s, or never at all.
  bool isAlive(const std::string& process, Clock::time_point now = Clock::now()) const;

 private:
  int socket_ = -1;
  std::map<std::string, Clock::time_point> heard_;
};

}  // namespace pongsim::ign
