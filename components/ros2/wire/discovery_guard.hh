#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>

#include "ros2/wire/discovery_acknacks.hh"
#include "shared/rtps/leases.hh"

namespace pongsim::ros2 {

/// Guards what a participant of Fast DDS 2.9 hears of others: it is told of leases that never end (`shared::Leases`),
/// and when one ends, of a goodbye. Announcements and goodbyes are handed to it one at a time. All that the participant
/// receives goes through here. What they ask for is answered (`DiscoveryAcknacks`).
///
/// Participants with pongsim's own topics, which share none with this one, are never heard.
///
/// There is no limit to the neighbours that are known, as there is none in Fast DDS, which needs much more memory for
/// each. Any thread may use this.
class DiscoveryGuard {
 public:
  using TimePoint = shared::Leases::TimePoint;
  using HandOn = std::function<void(std::span<const std::uint8_t>)>;

  DiscoveryGuard();

  /// Hands a received message on to Fast DDS, with endless leases. It is dropped if it is by or about a neighbour whose
  /// lease is over, until `end` has been called; and if Fast DDS would read a lease that could not be read here, or
  /// would not hear the goodbye of an announced participant (its endpoints lack the writer of announcements, or
  /// sequence numbers exceed 2^48).
  void receive(std::span<std::uint8_t> packet, TimePoint now, const HandOn& handOn);

  /// Ends the leases that are over.
  /// @param handOn Hands a message on as if it had been received where the participant hears announcements.
  /// @return When to call it again, in a second at the latest.
  TimePoint end(TimePoint now, const HandOn& handOn);

  std::size_t size() const;

 private:
  /// Held while Fast DDS handles an announcement; before `mutex_`.
  std::mutex turn_;
  mutable std::mutex mutex_;
  shared::Leases leases_;
  DiscoveryAcknacks acknacks_;
  std::uint64_t goodbyes_ = 0;
};

}  // namespace pongsim::ros2
