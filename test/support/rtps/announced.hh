#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hostile/packet.hh"

/// Announcements and goodbyes of participants that only tests have.
namespace pongsim::test {

/// The ids of parameters (RTPS 2.3, 9.6.2.2).
inline constexpr std::uint16_t kLeaseId = 0x02, kMetatrafficId = 0x32, kGuidId = 0x50, kEndpointsId = 0x58,
                               kNameId = 0x62, kKeyHashId = 0x70, kStatusId = 0x71;

struct Announced {
  hostile::Prefix participant{};
  /// In seconds; unset: none.
  std::optional<std::uint32_t> lease = 20;
  std::int64_t sequence = 1;
  /// The bits of the endpoints that all participants have: 1 is the writer of announcements.
  std::optional<std::uint32_t> endpoints = 0x3f;
  std::uint32_t entity = hostile::entity::kParticipant;
  /// Where it listens on this machine.
  std::uint32_t port = 9;
  /// Empty: none.
  std::string name = {};
};

/// Begins DATA up to its inline QoS.
inline void beginAnnouncement(hostile::Packet& packet, std::uint8_t flags, std::int64_t sequence) {
  packet.begin(hostile::Kind::kData, flags);
  packet.add16(0);
  packet.add16(16);
  packet.addEntity(hostile::entity::kSpdpReader);
  packet.addEntity(hostile::entity::kSpdpWriter);
  packet.addSequence(sequence);
}

inline void addLease(hostile::Packet& packet, std::uint32_t seconds, std::uint32_t fraction = 0) {
  packet.beginParameter(kLeaseId);
  packet.add32(seconds);
  packet.add32(fraction);
  packet.endParameter();
}

inline void addAnnouncement(hostile::Packet& packet, const Announced& announced) {
  constexpr std::uint8_t kData = 4;
  beginAnnouncement(packet, kData, announced.sequence);
  packet.add32(0x00000300);
  packet.addGuid(kGuidId, announced.participant, announced.entity);
  packet.addLocator(kMetatrafficId, 0x7f000001, announced.port);
  if (announced.endpoints) packet.addNumberParameter(kEndpointsId, *announced.endpoints);
  if (announced.lease) addLease(packet, *announced.lease);
  if (!announced.name.empty()) packet.addText(kNameId, announced.name);
  packet.addSentinel();
  packet.end();
}

/// Goodbyes as Fast DDS says them, which names itself in a hash of the key, and as Cyclone DDS does, in the key.
enum class Goodbye { kWithHash, kWithKey };

inline void addGoodbye(hostile::Packet& packet, const hostile::Prefix& participant, Goodbye form,
                       std::int64_t sequence = 2) {
  constexpr std::uint8_t kInlineQos = 2, kKey = 8;
  beginAnnouncement(packet, form == Goodbye::kWithKey ? kInlineQos | kKey : kInlineQos, sequence);
  if (form == Goodbye::kWithHash) packet.addGuid(kKeyHashId, participant, hostile::entity::kParticipant);
  packet.addNumberParameter(kStatusId, 0x03000000);
  packet.addSentinel();
  if (form == Goodbye::kWithKey) {
    packet.add32(0x00000300);
    packet.addGuid(kGuidId, participant, hostile::entity::kParticipant);
    packet.addSentinel();
  }
  packet.end();
}

/// What follows is somebody else's (INFO_SRC).
inline void addSource(hostile::Packet& packet, const hostile::Prefix& participant) {
  packet.begin(hostile::Kind::kInfoSrc);
  packet.add32(0);
  packet.add32(0x10010102);
  packet.addPrefix(participant);
  packet.end();
}

inline std::vector<std::uint8_t> bytesOf(const hostile::Packet& packet) {
  return {packet.bytes().begin(), packet.bytes().end()};
}

inline std::vector<std::uint8_t> announcementOf(const Announced& announced) {
  hostile::Packet packet(announced.participant);
  addAnnouncement(packet, announced);
  return bytesOf(packet);
}

inline std::vector<std::uint8_t> goodbyeOf(const hostile::Prefix& participant, Goodbye form = Goodbye::kWithHash) {
  hostile::Packet packet(participant);
  addGoodbye(packet, participant, form);
  return bytesOf(packet);
}

}  // namespace pongsim::test
