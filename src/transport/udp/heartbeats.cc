#include "transport/udp/heartbeats.hh"

namespace pongsim::transport {

namespace {

// Minimum interval between two equal heartbeats to a port, shorter than a writer's heartbeat period.
constexpr std::chrono::milliseconds kHeartbeatInterval{900};

}  // namespace

bool Heartbeats::goTo(std::uint32_t port, std::span<const shared::RtpsHeartbeat> heartbeats, TimePoint now) {
  bool isWanted = false;
  for (const shared::RtpsHeartbeat& each : heartbeats) {
    if (isAcknowledged_(port, each)) continue;
    const std::lock_guard lock(mutex_);
    const auto [sent, isNew] = sent_.try_emplace({port, each.writer});
    if (!isNew && sent->second.last == each.last && now - sent->second.at < kHeartbeatInterval) continue;
    sent->second = {each.last, now};
    isWanted = true;
  }
  return isWanted;
}

}  // namespace pongsim::transport
