#pragma once

#include <chrono>
#include <map>
#include <string>

namespace pongsim::ign {

/// Who of the other processes still announces itself, as all do once a second. The library itself takes those that were
/// killed for listeners forever. For one thread at a time.
class Heartbeats {
 public:
  using Clock = std::chrono::steady_clock;

  /// Listens where this process's discovery does.
  /// @param address At which this process speaks.
  explicit Heartbeats(const std::string& address);
  ~Heartbeats();
  Heartbeats(const Heartbeats&) = delete;
  Heartbeats& operator=(const Heartbeats&) = delete;

  /// Takes what has come. Never waits.
  void read();

  /// @return Whether the process with that number has been heard in the last 10 s, or never at all.
  bool isAlive(const std::string& process, Clock::time_point now = Clock::now()) const;

 private:
  int socket_ = -1;
  std::map<std::string, Clock::time_point> heard_;
};

}  // namespace pongsim::ign
