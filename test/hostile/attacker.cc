#include "hostile/attacker.hh"

#include <algorithm>
#include <array>
#include <limits>
#include <thread>
#include <utility>

namespace pongsim::hostile {

namespace {

// Ids of parameters (RTPS 2.3, 9.6.2.2).
constexpr std::uint16_t kLease = 0x02, kTopicName = 0x05, kTypeName = 0x07, kVersion = 0x15, kVendor = 0x16,
                        kReliability = 0x1a, kPartition = 0x29, kUserData = 0x2c, kUnicast = 0x2f,
                        kDefaultUnicast = 0x31, kMetatrafficUnicast = 0x32, kMetatrafficMulticast = 0x33,
                        kParticipantGuid = 0x50, kBuiltinEndpoints = 0x58, kProperties = 0x59, kEndpointGuid = 0x5a,
                        kName = 0x62, kKeyHash = 0x70, kStatus = 0x71;
// Status of an instance: disposed and unregistered, big-endian.
constexpr std::uint32_t kGone = 0x03000000;

constexpr std::uint32_t kLoopback = 0x7f000001;
// The built-in endpoints of every participant: writers and readers of participants, publications and subscriptions.
constexpr std::uint32_t kDiscovery = 0x3f;

constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();

// Topics of a running world. Attacks announce them with another type.
constexpr std::array<std::string_view, 5> kTopics = {"/clock", "/stats", "/cmd_vel", "pongsim/census", "/chatter"};

/// Adds the header of a sample that is a parameter list.
void beginList(Packet& packet) { packet.add32(0x00000300); }

constexpr std::array<std::pair<std::string_view, Attack>, 11> kAttacks = {{
    {"participants", Attack::kParticipants},
    {"sockets", Attack::kSockets},
    {"forged-participants", Attack::kForgedParticipants},
    {"endpoints", Attack::kEndpoints},
    {"parameters", Attack::kParameters},
    {"forged-data", Attack::kForgedData},
    {"fragments", Attack::kFragments},
    {"heartbeats", Attack::kHeartbeats},
    {"acknacks", Attack::kAckNacks},
    {"interpreter", Attack::kInterpreter},
    {"leases", Attack::kLeases},
}};

}  // namespace

std::span<const std::pair<std::string_view, Attack>> attacks() { return kAttacks; }

std::optional<Attack> attackOf(std::string_view name) {
  const auto found = std::ranges::find(kAttacks, name, &std::pair<std::string_view, Attack>::first);
  return found == kAttacks.end() ? std::nullopt : std::optional(found->second);
}

Attacker::Attacker(int domain, std::uint64_t seed)
    : domain_(domain), random_(seed), foothold_(domain), own_(freshPrefix()) {}

std::size_t Attacker::look(std::chrono::milliseconds atMost) {
  using std::chrono::milliseconds;
  // a participant that discovers a new one announces itself to it at once
  for (int i = 0; i < kMostParticipants; ++i) {
    const std::uint16_t port = discoveryPort(domain_, i);
    if (port != foothold_.port()) foothold_.send(participant(own_, true).bytes(), port);
  }
  neighbours_ = foothold_.hear(std::min(milliseconds(300), atMost), atMost);
  return neighbours_.size();
}

void Attacker::strike(Attack attack) {
  if (neighbours_.empty()) return;
  target_ = neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))];
  // messages of unknown participants are dropped early, so the attacker announces itself
  if (count_++ % 512 == 0 && attack != Attack::kLeases) send(participant(own_, true), target_.discoveryPort);
  switch (attack) {
    case Attack::kParticipants:
      return send(participant(freshPrefix(), false), target_.discoveryPort);
    case Attack::kSockets:
      ++sent_;
      return sendFromNewSocket(participant(freshPrefix(), oneIn(2)).bytes(), target_.discoveryPort);
    case Attack::kForgedParticipants:
      return send(forgedParticipant(), target_.discoveryPort);
    case Attack::kEndpoints:
      return send(floodOfEndpoints(), target_.discoveryPort);
    case Attack::kParameters:
      return send(brokenParameters(), target_.discoveryPort);
    case Attack::kForgedData:
      return send(forgedData(), oneIn(2) ? target_.discoveryPort : target_.userPort);
    case Attack::kFragments:
      return send(fragment(), target_.userPort);
    case Attack::kHeartbeats:
      return send(heartbeatOrGap(), oneIn(2) ? target_.discoveryPort : target_.userPort);
    case Attack::kAckNacks:
      return send(wantAgain(), oneIn(2) ? target_.discoveryPort : target_.userPort);
    case Attack::kInterpreter:
      return send(interpreter(), oneIn(2) ? target_.discoveryPort : target_.userPort);
    case Attack::kLeases:
      return endOnTime();
  }
}

void Attacker::send(const Packet& packet, std::uint16_t port) {
  foothold_.send(packet.bytes(), port);
  ++sent_;
}

Prefix Attacker::freshPrefix() {
  Prefix prefix{};
  for (std::uint8_t& each : prefix) each = static_cast<std::uint8_t>(below(256));
  // Fast DDS begins its prefixes with its vendor id
  prefix[0] = 1;
  prefix[1] = 0x0f;
  return prefix;
}

/// Fast DDS numbers its endpoints consecutively, so their ids are easy to guess.
EntityId Attacker::guessedEndpoint(bool isWriter) {
  constexpr std::uint32_t kWriterWithoutKey = 0x03, kReaderWithoutKey = 0x04;
  return (1 + below(64)) << 8 | (isWriter ? kWriterWithoutKey : kReaderWithoutKey);
}

std::int64_t Attacker::oddSequence() {
  switch (below(5)) {
    case 0:
      return kLast;
    case 1:
      return 0;
    case 2:
      return -1;
    case 3:
      return static_cast<std::int64_t>(below(1000));
    default:
      return static_cast<std::int64_t>(random_() >> below(63));
  }
}

std::string Attacker::enormousName() {
  const std::string name(below(oneIn(4) ? 60'000 : 300), static_cast<char>('a' + below(26)));
  return "/" + std::to_string(random_()) + name;
}

/// @param isHonest Whether the announcement is valid and has the attacker's own address.
/// @param lease Lease duration of an honest one [s].
Packet Attacker::participant(const Prefix& prefix, bool isHonest, std::uint32_t lease) {
  Packet packet(prefix);
  packet.beginData(entity::kSpdpReader, entity::kSpdpWriter, isHonest ? 1 : 1 + below(3), kWithData);
  beginList(packet);
  packet.addNumberParameter(kVersion, 0x0302);
  packet.addNumberParameter(kVendor, 0x0f01);
  packet.addGuid(kParticipantGuid, prefix, entity::kParticipant);
  packet.addNumberParameter(kBuiltinEndpoints, isHonest ? kDiscovery : oneIn(2) ? 0xffffffff : kDiscovery);
  packet.addText(kName, "pongsim/" + std::to_string(below(100'000)));
  if (isHonest) {
    packet.addLocator(kMetatrafficUnicast, kLoopback, foothold_.port());
    packet.addLocator(kDefaultUnicast, kLoopback, foothold_.port());
  } else {
    addOddLocators(packet);
  }
  packet.beginParameter(kLease);
  constexpr std::array<std::uint32_t, 5> kSeconds = {0, 1, 20, 0x7fffffff, 0xffffffff};
  packet.add32(isHonest ? lease : kSeconds[below(kSeconds.size())]);
  packet.add32(isHonest ? 0 : below(2) * 0xffffffff);
  packet.endParameter();
  packet.addSentinel();
  packet.end();
  return packet;
}

void Attacker::addOddLocators(Packet& packet) {
  // this machine, another host, a multicast group, broadcast, none
  constexpr std::array<std::uint32_t, 5> kAddresses = {kLoopback, 0xc0000201, 0xefff0001, 0xffffffff, 0};
  const std::array<std::uint32_t, 5> ports = {0, target_.discoveryPort, target_.userPort, 65535, 0xffffffff};
  for (const std::uint16_t id : {kMetatrafficUnicast, kDefaultUnicast, kMetatrafficMulticast}) {
    for (std::uint32_t i = below(6); i > 0; --i) {
      packet.addLocator(id, kAddresses[below(kAddresses.size())], ports[below(ports.size())]);
    }
  }
}

Packet Attacker::forgedParticipant() {
  const Neighbour& victim = neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))];
  if (oneIn(3)) return participant(victim.prefix, oneIn(2));
  // a message that ends the participant or one of its endpoints
  Packet packet(victim.prefix);
  const bool isParticipant = oneIn(2);
  const bool isWriter = oneIn(2);
  const EntityId writer = isParticipant ? entity::kSpdpWriter
                          : isWriter    ? entity::kPublicationsWriter
                                        : entity::kSubscriptionsWriter;
  packet.beginData(writer + 5, writer, 1 + below(200), kInlineQos);
  packet.addGuid(kKeyHash, victim.prefix, isParticipant ? entity::kParticipant : guessedEndpoint(isWriter));
  packet.addNumberParameter(kStatus, kGone);
  packet.addSentinel();
  packet.end();
  return packet;
}

Packet Attacker::endpoint(const Prefix& prefix, EntityId id, std::string_view topic, std::string_view type) {
  Packet packet(own_);
  const bool isWriter = (id & 0xff) == 0x03;
  const EntityId writer = isWriter ? entity::kPublicationsWriter : entity::kSubscriptionsWriter;
  packet.beginData(writer + 5, writer, 1 + count_, kWithData);
  beginList(packet);
  packet.addGuid(kEndpointGuid, prefix, id);
  packet.addGuid(kParticipantGuid, prefix, entity::kParticipant);
  packet.addText(kTopicName, topic);
  packet.addText(kTypeName, type);
  packet.beginParameter(kReliability);
  for (const std::uint32_t each : {2U, 0U, 100'000'000U}) packet.add32(each);
  packet.endParameter();
  packet.addLocator(kUnicast, kLoopback, foothold_.port());
  packet.addSentinel();
  packet.end();
  return packet;
}

Packet Attacker::floodOfEndpoints() {
  const EntityId id = (below(1 << 24) << 8) | (oneIn(2) ? 0x03 : 0x04);
  if (oneIn(3)) return endpoint(own_, id, kTopics[below(kTopics.size())], "ignition.msgs.Clock");
  // sometimes with the target's GUID
  return endpoint(oneIn(8) ? target_.prefix : own_, id, enormousName(),
                  oneIn(8) ? enormousName() : "ignition.msgs.Pose");
}

Packet Attacker::brokenParameters() {
  Packet packet(own_);
  const EntityId writer = oneIn(2) ? entity::kPublicationsWriter : entity::kSubscriptionsWriter;
  packet.beginData(writer + 5, writer, 1 + count_, kWithData);
  beginList(packet);
  if (!oneIn(4)) packet.addGuid(kEndpointGuid, own_, guessedEndpoint(oneIn(2)));
  for (std::uint32_t i = below(200); i > 0; --i) {
    constexpr std::array<std::uint16_t, 8> kIds = {kTopicName, kTypeName,   kPartition, kUserData,
                                                   kUnicast,   kProperties, kName,      kReliability};
    packet.beginParameter(oneIn(4) ? static_cast<std::uint16_t>(below(65536)) : kIds[below(kIds.size())]);
    packet.add32(oneIn(2) ? 0xffffffff : below(64));
    packet.addZeros(below(8) * 4);
    packet.endParameter(oneIn(8) ? std::optional(static_cast<std::uint16_t>(below(65536))) : std::nullopt);
  }
  if (!oneIn(4)) packet.addSentinel();
  packet.end();
  return packet;
}

Packet Attacker::forgedData() {
  const Neighbour& victim = neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))];
  Packet packet(victim.prefix);
  const bool isDiscovery = oneIn(3);
  const EntityId writer = isDiscovery ? entity::kPublicationsWriter : guessedEndpoint(true);
  const EntityId reader = isDiscovery ? writer + 5 : oneIn(2) ? 0 : guessedEndpoint(false);
  packet.beginData(reader, writer, oddSequence(), kWithData);
  packet.add32(0x00000100);
  packet.add32(oneIn(4) ? 0xffffffff : 16);
  packet.addZeros(4 * below(64));
  packet.end();
  return packet;
}

Packet Attacker::fragment() {
  constexpr EntityId kWriter = 0x00000103;
  // announce a publisher of the attacker's own, so that subscribers accept its fragments
  if (oneIn(64)) return endpoint(own_, kWriter, "/chatter", "ignition.msgs.StringMsg");
  Packet packet(oneIn(2) ? own_ : neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))].prefix);
  packet.begin(Kind::kDataFrag);
  packet.add16(0);
  packet.add16(28);
  packet.addEntity(oneIn(2) ? 0 : guessedEndpoint(false));
  packet.addEntity(oneIn(2) ? kWriter : guessedEndpoint(true));
  packet.addSequence(oneIn(2) ? 1 + below(1000) : oddSequence());
  packet.add32(oneIn(8) ? 0xffffffff : below(10));
  packet.add16(static_cast<std::uint16_t>(oneIn(8) ? 0xffff : 1 + below(4)));
  packet.add16(static_cast<std::uint16_t>(oneIn(4) ? below(65536) : 1024));
  packet.add32(oneIn(4) ? 0xffffffff : oneIn(2) ? 1 << 30 : below(100'000));
  packet.addZeros(4 + 4 * below(512));
  packet.end();
  return packet;
}

Packet Attacker::heartbeatOrGap() {
  const Neighbour& victim = neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))];
  Packet packet(oneIn(4) ? own_ : victim.prefix);
  const EntityId writer = oneIn(3) ? entity::kPublicationsWriter : guessedEndpoint(true);
  const EntityId reader = oneIn(2) ? 0 : oneIn(2) ? entity::kPublicationsReader : guessedEndpoint(false);
  for (std::uint32_t i = 1 + below(8); i > 0; --i) {
    const bool isGap = oneIn(2);
    packet.begin(isGap ? Kind::kGap : Kind::kHeartbeat);
    packet.addEntity(reader);
    packet.addEntity(writer);
    packet.addSequence(oddSequence());
    if (isGap) {
      packet.addSequenceSet(oddSequence(), oneIn(4) ? 0xffffffff : below(257));
    } else {
      packet.addSequence(oddSequence());
      packet.add32(oneIn(2) ? 0x7fffffff : count_);
    }
    packet.end();
  }
  return packet;
}

Packet Attacker::wantAgain() {
  const Neighbour& victim = neighbours_[below(static_cast<std::uint32_t>(neighbours_.size()))];
  if (oneIn(64)) return endpoint(own_, 0x00000104, "/chatter", "ignition.msgs.StringMsg");
  if (oneIn(64)) return endpoint(own_, 0x00000204, "/clock", "ignition.msgs.Clock");
  Packet packet(oneIn(2) ? own_ : victim.prefix);
  packet.begin(Kind::kInfoDst);
  packet.addPrefix(target_.prefix);
  packet.end();
  for (std::uint32_t i = 1 + below(16); i > 0; --i) {
    const bool isFragments = oneIn(4);
    packet.begin(isFragments ? Kind::kNackFrag : Kind::kAckNack);
    packet.addEntity(oneIn(2) ? entity::kSubscriptionsReader : guessedEndpoint(false));
    packet.addEntity(oneIn(2) ? entity::kSubscriptionsWriter : guessedEndpoint(true));
    if (isFragments) {
      packet.addSequence(1 + below(1000));
      packet.add32(1);
      packet.add32(256);
      for (int word = 0; word < 8; ++word) packet.add32(0xffffffff);
    } else {
      packet.addSequenceSet(oneIn(2) ? 1 : oddSequence(), oneIn(8) ? 0xffffffff : 256);
    }
    packet.add32(count_ * 16 + i);
    packet.end();
  }
  return packet;
}

Packet Attacker::interpreter() {
  Packet packet(oneIn(2) ? own_ : target_.prefix);
  for (std::uint32_t i = 1 + below(100); i > 0; --i) {
    constexpr std::array<Kind, 8> kKinds = {Kind::kInfoTs,
                                            Kind::kInfoSrc,
                                            Kind::kInfoDst,
                                            Kind::kPad,
                                            Kind::kSecureBody,
                                            Kind::kSecurePrefix,
                                            Kind::kSecureMessagePrefix,
                                            Kind::kHeartbeatFrag};
    const Kind kind = kKinds[below(kKinds.size())];
    packet.begin(kind, static_cast<std::uint8_t>(below(256)));
    const bool isNamed = kind == Kind::kInfoDst || kind == Kind::kInfoSrc;
    if (kind == Kind::kInfoSrc) packet.add32(0);
    if (kind == Kind::kInfoSrc) packet.add32(0x0f010302);
    if (isNamed) packet.addPrefix(oneIn(2) ? target_.prefix : freshPrefix());
    if (!isNamed) packet.addZeros(4 * below(16));
    packet.end(oneIn(16) ? std::optional(static_cast<std::uint16_t>(below(65536))) : std::nullopt);
  }
  const Packet last = oneIn(2) ? forgedData() : forgedParticipant();
  packet.addBytes(last.bytes().subspan(20));
  return packet;
}

/// Announces a participant with a lease of a second to all neighbours, or says goodbye for one at the end of its lease.
void Attacker::endOnTime() {
  using std::chrono::microseconds;
  // receivers accept only this many participants of one socket in addition to the attacker
  constexpr std::size_t kAtOnce = 3;
  const auto now = std::chrono::steady_clock::now();
  if (ends_.size() < kAtOnce) {
    ends_.emplace_back(freshPrefix(), now + std::chrono::seconds(1) + microseconds(below(400)));
    for (const Neighbour& each : neighbours_) send(participant(ends_.back().first, true, 1), each.discoveryPort);
    return;
  }
  const auto [prefix, end] = ends_.front();
  if (now < end) return std::this_thread::sleep_until(std::min(end, now + std::chrono::milliseconds(1)));
  for (const Neighbour& each : neighbours_) send(goodbye(prefix), each.discoveryPort);
  ends_.pop_front();
}

}  // namespace pongsim::hostile
