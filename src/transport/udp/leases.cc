#include "transport/udp/leases.hh"

#include "transport/wire_number.hh"

#include <algorithm>

namespace pongsim::transport {

namespace {

// 34 years: what is added to a clock's time in nanoseconds must not overflow.
constexpr std::uint32_t kEndless = 1 << 30;

constexpr std::chrono::seconds kTellAgain{1};
constexpr int kMostTold = 5;

// By then it has long been handled.
constexpr std::chrono::nanoseconds kGoodbye = std::chrono::seconds(10);

}  // namespace

/// @return The announced lease, within bounds.
std::chrono::nanoseconds Leases::makeEndless(std::span<std::uint8_t> bytes, const RtpsDiscovery& announcement) const {
  if (!announcement.leaseAt) return bounds_.longest;
  const auto place = bytes.subspan(*announcement.leaseAt, 8);
  // unsigned: a negative one is long
  const std::chrono::seconds seconds(
      readNumber(std::span<const std::uint8_t>(place.first(4)), announcement.isLittleEndian));
  const std::uint64_t fraction =
      readNumber(std::span<const std::uint8_t>(place.subspan(4)), announcement.isLittleEndian);
  writeNumber(kEndless, place.first(4), announcement.isLittleEndian);
  const std::chrono::nanoseconds lease = seconds + std::chrono::nanoseconds(fraction * 1'000'000'000 >> 32);
  return std::clamp(lease, bounds_.shortest, bounds_.longest);
}

bool Leases::hear(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now) {
  const auto found = neighbours_.find(message.source);
  if (found != neighbours_.end()) {
    if (found->second.hasEnded) return false;
    found->second.heard = now;
  }
  for (const RtpsDiscovery& sample : message.discovery) {
    if (!sample.isOfParticipant() || sample.prefix != message.source) continue;
    Neighbour& neighbour = neighbours_[message.source];
    neighbour.heard = now;
    // not before the library has heard of the goodbye
    neighbour.lease = sample.isAlive ? makeEndless(bytes, sample) : std::max(neighbour.lease, kGoodbye);
    neighbour.sequence = std::max(neighbour.sequence, sample.sequence);
  }
  return true;
}

void Leases::discovered(const RtpsPrefix& prefix, TimePoint now) {
  const auto [place, isNew] = neighbours_.try_emplace(prefix);
  if (!isNew) return;
  place->second.heard = now;
  place->second.lease = bounds_.longest;
}

void Leases::end(const RtpsPrefix& prefix) {
  if (const auto found = neighbours_.find(prefix); found != neighbours_.end()) found->second.hasEnded = true;
}

bool Leases::runs(const RtpsPrefix& prefix) const {
  const auto found = neighbours_.find(prefix);
  return found != neighbours_.end() && !found->second.hasEnded;
}

bool Leases::hasEnded(const RtpsPrefix& prefix) const {
  const auto found = neighbours_.find(prefix);
  return found != neighbours_.end() && found->second.hasEnded;
}

std::vector<Leases::Ending> Leases::endings(TimePoint now) {
  std::vector<Ending> endings;
  // those it never got to know
  std::erase_if(neighbours_, [now](const auto& each) {
    return each.second.timesTold == kMostTold && now - each.second.told >= kTellAgain;
  });
  for (auto& [prefix, neighbour] : neighbours_) {
    if (now - neighbour.heard > neighbour.lease) neighbour.hasEnded = true;
    if (!neighbour.hasEnded || (neighbour.timesTold > 0 && now - neighbour.told < kTellAgain)) continue;
    // each must be newer than what the library has seen
    endings.push_back({prefix, announcementWithoutLease(prefix, ++neighbour.sequence)});
    ++neighbour.timesTold;
    neighbour.told = now;
  }
  return endings;
}

Leases::TimePoint Leases::nextLook(TimePoint now) const {
  TimePoint next = now + kTellAgain;
  for (const auto& [prefix, neighbour] : neighbours_) {
    if (!neighbour.hasEnded) next = std::min(next, neighbour.heard + neighbour.lease + std::chrono::nanoseconds(1));
  }
  return next;
}

}  // namespace pongsim::transport
