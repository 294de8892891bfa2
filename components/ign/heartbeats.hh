#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace pongsim::ign {

/// Tracks which other processes are alive, by ign-transport's heartbeats, which each process multicasts once a second.
/// The library itself keeps killed processes as subscribers for ever. For one thread at a time.
class Heartbeats {
 public:
  using Clock = std::chrono::steady_clock;

  /// Receives on the port of this process's discovery.
  /// @param address IPv4 address at which this process uses ign-transport.
  explicit Heartbeats(const std::string& address);
  ~Heartbeats();
  Heartbeats(const Heartbeats&) = delete;
  Heartbeats& operator=(const Heartbeats&) = delete;

  /// Reads all heartbeats that have arrived. Never blocks.
  void read();

  /// @return Whether somebody has asked for the list of subscribers (`SubscriberList`) since the last call.
  bool takeRequest() { return std::exchange(isAsked_, false); }

  /// @return Whether a heartbeat of the process with this id arrived in the last 10 s, or none has ever arrived.
  bool isAlive(const std::string& process, Clock::time_point now = Clock::now()) const;

 private:
  int socket_ = -1;
  bool isAsked_ = false;
  std::map<std::string, Clock::time_point> heard_;
};

}  // namespace pongsim::ign
