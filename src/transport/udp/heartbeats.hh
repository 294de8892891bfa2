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

/// Filters heartbeats of the discovery writers (SEDP): decides for each discovery port of this machine whether one is
/// sent.
///
/// While any reader has not acknowledged everything, Fast DDS 2.9 sends a heartbeat to all participants each second,
/// and another after each sample that is requested again; each participant answers each heartbeat. A hundred processes
/// that start together spend so much time on this that they lose messages and request them again. So a participant that
/// has acknowledged everything gets no heartbeat, and others get equal heartbeats once per second. Thread-safe.
class Heartbeats {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// @return Whether all participants at the port have acknowledged all samples that the heartbeat announces.
  using IsAcknowledged = std::function<bool(std::uint32_t port, const shared::RtpsHeartbeat& heartbeat)>;

  explicit Heartbeats(IsAcknowledged isAcknowledged) : isAcknowledged_(std::move(isAcknowledged)) {}

  /// @param heartbeats All heartbeats of a message.
  /// @return Whether to send the message to this port; if so, it is recorded as sent.
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
