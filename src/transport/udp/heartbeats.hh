#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "shared/rtps/rtps_message.hh"

namespace pongsim::transport {

/// Decides which discovery ports of this machine the heartbeats of discovery's writers go to.
///
/// Fast DDS 2.9 sends one to all participants each second while a single one has not acknowledged everything, and after
/// each sample that a single one asks for. Each is answered by all. A hundred processes that start at once spend so
/// much on that that they lose messages, and have to ask again. So a participant that has acknowledged everything gets
/// none, and another one the same one once per second. Thread-safe.
class Heartbeats {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// @return Whether all participants at the port have acknowledged all that the heartbeat announces.
  using IsAcknowledged = std::function<bool(std::uint32_t port, const shared::RtpsHeartbeat& heartbeat)>;

  explicit Heartbeats(IsAcknowledged isAcknowledged) : isAcknowledged_(std::move(isAcknowledged)) {}

  /// @param heartbeats All that is in a message.
  /// @return Whether to send the message to this port; it then counts as sent.
  bool goTo(std::uint32_t port, std::span<const shared::RtpsHeartbeat> heartbeats, TimePoint now);

 private:
  struct Sent {
    std::uint64_t last = 0;
    TimePoint at;
  };

  IsAcknowledged isAcknowledged_;
  std::mutex mutex_;
  std::map<std::pair<std::uint32_t, shared::RtpsEntity>, Sent> sent_;
};

}  // namespace pongsim::transport
