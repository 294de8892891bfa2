#include "shared/rtps/leases.hh"

#include <algorithm>

#include "shared/rtps/wire_number.hh"

namespace pongsim::shared {

namespace {

// 34 years [s]: added to a clock's time in nanoseconds it does not overflow.
constexpr std::uint32_t kEndless = 1 << 30;

constexpr std::chrono::seconds kTellAgain{1};
constexpr int kMostTold = 5;

// So that many leases that end one after the other are looked at together.
constexpr std::chrono::milliseconds kSoonestLook{10};

void makeEndless(std::span<std::uint8_t> bytes, const RtpsDiscovery& announcement) {
  for (const std::size_t at : announcement.leasesAt) {
    writeNumber(kEndless, bytes.subspan(at, 4), announcement.isLittleEndian);
    writeNumber(0, bytes.subspan(at + 4, 4), announcement.isLittleEndian);
  }
}

}  // namespace

bool Leases::hear(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now) {
  const auto isOver = [&](const RtpsPrefix& prefix) {
    const auto found = neighbours_.find(prefix);
    return found != neighbours_.end() && (found->second.hasEnded = found->second.isOver(now));
  };
  if (isOver(message.source) || std::ranges::any_of(message.otherSources, isOver)) return false;
  for (const RtpsDiscovery& sample : message.discovery) {
    if (sample.isOfParticipant() && isOver(sample.participant())) return false;
  }
  const auto hear = [&](const RtpsPrefix& prefix) {
    if (const auto found = neighbours_.find(prefix); found != neighbours_.end()) found->second.heard = now;
  };
  hear(message.source);
  std::ranges::for_each(message.otherSources, hear);
  for (const RtpsDiscovery& sample : message.discovery) {
    if (!sample.isOfParticipant()) continue;
    // nobody becomes known by a goodbye
    if (!sample.isAlive && !neighbours_.contains(sample.participant())) continue;
    Neighbour& neighbour = neighbours_[sample.participant()];
    neighbour.heard = now;
    neighbour.lease = !sample.isAlive
                          ? bounds_.afterGoodbye
                          : std::clamp(sample.lease.value_or(bounds_.longest), bounds_.shortest, bounds_.longest);
    neighbour.sequence = std::max(neighbour.sequence, sample.sequence);
    makeEndless(bytes, sample);
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
  // those that the library never got to know
  std::erase_if(neighbours_, [now](const auto& each) {
    return each.second.timesTold == kMostTold && now - each.second.told >= kTellAgain;
  });
  for (auto& [prefix, neighbour] : neighbours_) {
    neighbour.hasEnded = neighbour.isOver(now);
    if (!neighbour.hasEnded || (neighbour.timesTold > 0 && now - neighbour.told < kTellAgain)) continue;
    endings.push_back({prefix, ++neighbour.sequence});
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
  return std::max(next, now + kSoonestLook);
}

}  // namespace pongsim::shared
