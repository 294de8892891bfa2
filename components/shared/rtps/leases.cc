#include "shared/rtps/leases.hh"

#include <algorithm>

#include "shared/rtps/wire_number.hh"

namespace pongsim::shared {

namespace {

// Seconds, 34 years: Fast DDS adds it to a time in nanoseconds, which must not overflow.
constexpr std::uint32_t kInfinite = 1 << 30;

constexpr std::chrono::seconds kReportPeriod{1};
constexpr int kMostReports = 5;

// So that one check covers many leases that end shortly after each other.
constexpr std::chrono::milliseconds kShortestWait{10};

void makeInfinite(std::span<std::uint8_t> bytes, const RtpsDiscovery& announcement) {
  for (const std::size_t at : announcement.leasesAt) {
    writeNumber(kInfinite, bytes.subspan(at, 4), announcement.isLittleEndian);
    writeNumber(0, bytes.subspan(at + 4, 4), announcement.isLittleEndian);
  }
}

}  // namespace

bool Leases::receive(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now) {
  const auto isOver = [&](const RtpsPrefix& prefix) {
    const auto found = participants_.find(prefix);
    return found != participants_.end() && (found->second.hasEnded = found->second.isOver(now));
  };
  if (isOver(message.source) || std::ranges::any_of(message.otherSources, isOver)) return false;
  for (const RtpsDiscovery& sample : message.discovery) {
    if (sample.isOfParticipant() && isOver(sample.participant())) return false;
  }
  const auto renew = [&](const RtpsPrefix& prefix) {
    if (const auto found = participants_.find(prefix); found != participants_.end()) found->second.lastMessage = now;
  };
  renew(message.source);
  std::ranges::for_each(message.otherSources, renew);
  for (const RtpsDiscovery& sample : message.discovery) {
    if (!sample.isOfParticipant()) continue;
    // the end of an unknown participant does not make it known
    if (!sample.isAlive && !participants_.contains(sample.participant())) continue;
    Participant& participant = participants_[sample.participant()];
    participant.lastMessage = now;
    participant.lease = !sample.isAlive
                            ? bounds_.afterGoodbye
                            : std::clamp(sample.lease.value_or(bounds_.longest), bounds_.shortest, bounds_.longest);
    participant.sequence = std::max(participant.sequence, sample.sequence);
    makeInfinite(bytes, sample);
  }
  return true;
}

void Leases::discovered(const RtpsPrefix& prefix, TimePoint now) {
  const auto [place, isNew] = participants_.try_emplace(prefix);
  if (!isNew) return;
  place->second.lastMessage = now;
  place->second.lease = bounds_.longest;
}

void Leases::end(const RtpsPrefix& prefix) {
  if (const auto found = participants_.find(prefix); found != participants_.end()) found->second.hasEnded = true;
}

bool Leases::runs(const RtpsPrefix& prefix) const {
  const auto found = participants_.find(prefix);
  return found != participants_.end() && !found->second.hasEnded;
}

bool Leases::hasEnded(const RtpsPrefix& prefix) const {
  const auto found = participants_.find(prefix);
  return found != participants_.end() && found->second.hasEnded;
}

std::vector<Leases::Expired> Leases::expired(TimePoint now) {
  std::vector<Expired> expired;
  // forgets participants that Fast DDS has never discovered, and so does not remove
  std::erase_if(participants_, [now](const auto& each) {
    return each.second.reports == kMostReports && now - each.second.reportedAt >= kReportPeriod;
  });
  for (auto& [prefix, participant] : participants_) {
    participant.hasEnded = participant.isOver(now);
    if (!participant.hasEnded || (participant.reports > 0 && now - participant.reportedAt < kReportPeriod)) continue;
    expired.push_back({prefix, ++participant.sequence});
    ++participant.reports;
    participant.reportedAt = now;
  }
  return expired;
}

Leases::TimePoint Leases::nextCheck(TimePoint now) const {
  TimePoint next = now + kReportPeriod;
  for (const auto& [prefix, participant] : participants_) {
    if (!participant.hasEnded)
      next = std::min(next, participant.lastMessage + participant.lease + std::chrono::nanoseconds(1));
  }
  return std::max(next, now + kShortestWait);
}

}  // namespace pongsim::shared
