#include "transport/udp/rtps_filter.hh"

#include <algorithm>
#include <utility>

#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

// Limits on known participants: in total, per socket, and per discovery port of this machine. The latter is above 1,
// because a killed participant stays known until its lease ends, while its successor uses the same port.
constexpr std::size_t kMostParticipants = 512, kMostOfSocket = 4, kMostAtPort = 4;
// Limit per address of another machine: about the number of discovery ports that a domain has there.
constexpr std::ptrdiff_t kMostOfAddress = 128;

// Bounds of a participant's lease duration.
constexpr std::chrono::seconds kShortestLease{1}, kLongestLease{100};
// Time limit for Fast DDS to remove a participant that has announced its end (DISPOSE or UNREGISTER).
constexpr std::chrono::seconds kGoodbye{10};

// An announcement that Fast DDS has already processed is passed to it again only after this time: it would only renew
// the lease, and leases are kept in `leases_`.
constexpr std::chrono::seconds kRenewal{10};

constexpr std::uint32_t kThisMachinesNet = 127;

}  // namespace

// Above what a well-behaved participant sends. What exceeds the limits is dropped, and reliable DDS writers send it
// again.
RtpsFilter::RemoteParticipant::RemoteParticipant()
    : endpoints(5000, 100), endpointBytes(8 << 20, 128 << 10), gaps(1e6, 16e3), repeatRequests(1e4, 5e3) {}

bool RtpsFilter::RemoteParticipant::isWithinLimits(const RtpsMessage& message, TimePoint now) {
  for (const RtpsDiscovery& sample : message.discovery) {
    if (sample.isOfParticipant()) continue;
    if (!endpoints.take(1, now) || !endpointBytes.take(static_cast<double>(sample.bytes), now)) return false;
  }
  return gaps.take(static_cast<double>(message.gapNumbers), now) &&
         repeatRequests.take(static_cast<double>(message.repeatRequests), now);
}

/// Records what the participant acknowledges.
/// @return Whether the participant has removed this one and discovered it again: an ACKNACK whose base (lowest missing
/// sequence number) is below that of an earlier one shows it. The first ACKNACK after the discovery, whose base is 0,
/// requests all data again but may be lost, and Fast DDS 2.9 does not answer later ones.
bool RtpsFilter::RemoteParticipant::hasRediscovered(const RtpsMessage& message) {
  for (const RtpsAcknowledgement& each : message.acknowledgements) {
    const auto [last, isFirst] = acknowledged.try_emplace(each.writer, each);
    if (isFirst || each.count <= last->second.count) continue;
    if (each.below > 0 && each.below < last->second.below) return true;
    last->second = each;
  }
  return false;
}

/// @return Whether to pass the message to Fast DDS: false for the repetition of an announcement that it has processed.
bool RtpsFilter::RemoteParticipant::isNewToDds(const RtpsMessage& message, TimePoint now) {
  if (!message.isAnnouncement()) return true;
  const std::uint64_t sequence = message.discovery.front().sequence;
  if (isDiscovered && sequence <= passedSequence && now - passedAt < kRenewal) return false;
  passedSequence = std::max(passedSequence, sequence);
  passedAt = now;
  return true;
}

RtpsFilter::RtpsFilter(Sockets sockets)
    : sockets_(std::move(sockets)), leases_({kShortestLease, kLongestLease, kGoodbye}) {}

RtpsFilter::Decision RtpsFilter::decide(std::span<std::uint8_t> bytes, const RtpsAddress& from, Side side,
                                        TimePoint now) {
  const std::optional<RtpsMessage> message = shared::readRtpsMessage(bytes);
  if (!message || message->largestFragmented > payloadSize(kMaximumMessage)) return {};
  bool isGoodbye = false;
  for (const RtpsDiscovery& sample : message->discovery) {
    if (sample.prefix != message->source) return {};
    // Fast DDS would read a missing lease as zero, and remove the participant after each announcement
    if (sample.isOfParticipant() && sample.isAlive && !sample.lease) return {};
    if (shared::isOfPongsimRos(sample)) return {};
    isGoodbye |= sample.isOfParticipant() && !sample.isAlive;
  }
  const std::lock_guard lock(mutex_);
  if (ignored_.contains(message->source) || leases_.hasEnded(message->source)) return {};
  const auto found = participants_.find(message->source);
  RemoteParticipant* participant =
      found == participants_.end() ? addParticipant(*message, from, side, now) : &found->second;
  if (participant == nullptr || !isItsSocket(*participant, from) || !participant->isWithinLimits(*message, now))
    return {};
  if (participant->hasRediscovered(*message)) {
    leases_.end(message->source);
    return {};
  }
  if (!leases_.receive(*message, bytes, now)) return {};
  if (!participant->isNewToDds(*message, now)) return {};
  return {true, isGoodbye ? lastAcknowledgement(message->source) : std::vector<std::uint8_t>()};
}

void RtpsFilter::recordSent(const RtpsMessage& message) {
  const std::lock_guard lock(mutex_);
  const auto note = [this](RtpsEntity writer, std::uint64_t number) {
    if (writer != shared::kSpdpWriter) sent_[writer] = std::max(sent_[writer], number);
  };
  for (const RtpsDiscovery& each : message.discovery) note(each.writer, each.sequence);
  for (const RtpsHeartbeat& each : message.heartbeats) note(each.writer, each.last);
}

/// @return A message with ACKNACKs in the participant's name, for all discovery data sent so far; empty if none has
/// been sent or the participant is not participant.
std::vector<std::uint8_t> RtpsFilter::lastAcknowledgement(const RtpsPrefix& prefix) const {
  const auto participant = participants_.find(prefix);
  if (participant == participants_.end() || sent_.empty()) return {};
  std::vector<RtpsAcknowledgement> all;
  for (const auto& [writer, number] : sent_) {
    const auto last = participant->second.acknowledged.find(writer);
    const std::uint32_t count = last == participant->second.acknowledged.end() ? 0 : last->second.count;
    all.push_back({writer, number + 1, count + 1});
  }
  return shared::acknowledgementBy(prefix, all);
}

void RtpsFilter::discovered(const RtpsPrefix& prefix, TimePoint now) {
  const std::lock_guard lock(mutex_);
  leases_.discovered(prefix, now);
  if (const auto found = participants_.find(prefix); found != participants_.end()) found->second.isDiscovered = true;
}

void RtpsFilter::removed(const RtpsPrefix& prefix) {
  const std::lock_guard lock(mutex_);
  leases_.removed(prefix);
  participants_.erase(prefix);
}

void RtpsFilter::ignore(const RtpsPrefix& prefix, std::uint32_t port) {
  const std::lock_guard lock(mutex_);
  ignored_.emplace(prefix, port);
}

bool RtpsFilter::isAcknowledged(std::uint32_t port, const RtpsHeartbeat& heartbeat) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::any_of(ignored_, [port](const auto& each) { return each.second == port; })) return true;
  bool isSomebodyThere = false;
  for (const auto& [prefix, participant] : participants_) {
    if (participant.side != Side::kLoopback || participant.port != port) continue;
    const auto last = participant.acknowledged.find(heartbeat.writer);
    if (last == participant.acknowledged.end() || last->second.below <= heartbeat.last) return false;
    isSomebodyThere = true;
  }
  return isSomebodyThere;
}

RtpsFilter::Expiry RtpsFilter::expireLeases(TimePoint now) {
  const std::lock_guard lock(mutex_);
  Expiry expiry;
  for (const auto& [prefix, sequence] : leases_.expired(now)) {
    if (auto before = lastAcknowledgement(prefix); !before.empty()) expiry.messages.push_back(std::move(before));
    expiry.messages.push_back(shared::announcementWithoutLease(prefix, sequence));
  }
  expiry.nextCheck = leases_.nextCheck(now);
  std::erase_if(participants_, [this](const auto& each) { return !leases_.runs(each.first); });
  return expiry;
}

/// @return Whether the participant sends from this socket. It may use one socket for each of its addresses.
bool RtpsFilter::isItsSocket(RemoteParticipant& participant, const RtpsAddress& from) {
  const auto same = std::ranges::find(participant.sockets, from.address, &RtpsAddress::address);
  if (same != participant.sockets.end()) return *same == from;
  const bool isItsOwn =
      from.address >> 24 == kThisMachinesNet ||
      std::ranges::find(participant.addresses, from.address, &RtpsAddress::address) != participant.addresses.end();
  if (isItsOwn) participant.sockets.push_back(from);
  return isItsOwn;
}

/// Adds a participant, if the message is its announcement, and the socket and discovery port in it exist.
/// @return Null if they do not exist, or a limit is reached.
RtpsFilter::RemoteParticipant* RtpsFilter::addParticipant(const RtpsMessage& message, const RtpsAddress& from,
                                                          Side side, TimePoint now) {
  const auto announcement = std::ranges::find_if(
      message.discovery, [](const RtpsDiscovery& sample) { return sample.isOfParticipant() && sample.isAlive; });
  if (announcement == message.discovery.end()) return nullptr;
  const std::vector<RtpsAddress>& places = announcement->discoveryAddresses;
  const auto fits = [&](const RtpsAddress& place) {
    return side == Side::kLoopback ? sockets_.isDiscovery(place.port) : place.address == from.address;
  };
  // checked first, because it is cheaper than a query of the system's sockets
  if (std::ranges::count_if(participants_, [&](const auto& each) {
        return std::ranges::count(each.second.sockets, from) > 0;
      }) >= static_cast<std::ptrdiff_t>(kMostOfSocket)) {
    return nullptr;
  }
  if (side == Side::kLoopback && !socketQueries_.take(1, now)) return nullptr;
  const auto place = std::ranges::find_if(places, fits);
  if (place == places.end() || !isRoomFor(place->port, from, side)) return nullptr;
  RemoteParticipant& participant = participants_[message.source];
  participant.sockets = {from};
  participant.addresses = announcement->addresses;
  participant.port = place->port;
  participant.side = side;
  return &participant;
}

/// Makes room at a discovery port of this machine by ending the leases of participants whose sockets are closed.
/// @return Whether another participant can be added there, and its socket is open.
bool RtpsFilter::isRoomFor(std::uint32_t port, const RtpsAddress& from, Side side) {
  if (leases_.size() >= kMostParticipants) return false;
  if (side == Side::kNetwork) {
    return std::ranges::count_if(participants_, [&](const auto& each) {
             return each.second.side == side && each.second.sockets.front().address == from.address;
           }) < kMostOfAddress;
  }
  if (!sockets_.isOpen(from)) return false;
  // participants on other machines may have the same port number
  const auto isAtPort = [&](const auto& each) {
    return each.second.side == side && each.second.port == port && leases_.runs(each.first);
  };
  if (std::ranges::count_if(participants_, isAtPort) < static_cast<std::ptrdiff_t>(kMostAtPort)) return true;
  for (const auto& each : participants_) {
    if (isAtPort(each) && std::ranges::none_of(each.second.sockets, sockets_.isOpen)) leases_.end(each.first);
  }
  return std::ranges::count_if(participants_, isAtPort) < static_cast<std::ptrdiff_t>(kMostAtPort);
}

}  // namespace pongsim::transport
