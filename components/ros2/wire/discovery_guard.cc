#include "ros2/wire/discovery_guard.hh"

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace pongsim::ros2 {

namespace {

// More than can be announced.
constexpr std::chrono::hours kForever{24 * 365 * 140};
// Fast DDS 2.9 makes nothing of Cyclone's goodbye: it hears another at once.
constexpr std::chrono::nanoseconds kNoLease{0};

/// @return Whether Fast DDS finds nothing in it of participants that was not found here, and hears of each when it
/// ends.
bool isUnderstood(const shared::RtpsMessage& message) {
  return !message.hasUnreadParticipant && std::ranges::all_of(message.discovery, [](const auto& sample) {
    return !sample.isOfParticipant() || sample.isGone ||
           (sample.isAlive && sample.prefix && sample.lease && sample.announcesItself);
  });
}

}  // namespace

DiscoveryGuard::DiscoveryGuard() : leases_({std::chrono::nanoseconds(0), kForever, kNoLease}) {}

void DiscoveryGuard::receive(std::span<std::uint8_t> packet, TimePoint now, const HandOn& handOn) {
  const std::optional<shared::RtpsMessage> message = shared::readAnyRtpsMessage(packet);
  if (!message || !isUnderstood(*message)) return;
  if (std::ranges::any_of(message->discovery, shared::isOfPongsim)) return;
  std::unique_lock turn(turn_, std::defer_lock);
  if (std::ranges::any_of(message->discovery, &shared::RtpsDiscovery::isOfParticipant)) turn.lock();
  {
    const std::lock_guard lock(mutex_);
    if (!leases_.receive(*message, packet, now)) return;
    if (leases_.runs(message->source)) acknacks_.modify(message->source, packet);
  }
  handOn(packet);
}

DiscoveryGuard::TimePoint DiscoveryGuard::end(TimePoint now, const HandOn& handOn) {
  const std::lock_guard turn(turn_);
  std::vector<std::vector<std::uint8_t>> goodbyes;
  TimePoint next;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& each : leases_.expired(now)) {
      goodbyes.push_back(shared::goodbyeBy(each.prefix, ++goodbyes_));
      leases_.removed(each.prefix);
      acknacks_.forget(each.prefix);
    }
    next = leases_.nextCheck(now);
  }
  for (const std::vector<std::uint8_t>& each : goodbyes) handOn(each);
  return next;
}

std::size_t DiscoveryGuard::size() const {
  const std::lock_guard lock(mutex_);
  return leases_.size();
}

}  // namespace pongsim::ros2
