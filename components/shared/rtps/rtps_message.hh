#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::shared {

/// The participant's part of a GUID.
using RtpsPrefix = std::array<std::uint8_t, 12>;
/// The endpoint's part, most significant byte first.
using RtpsEntity = std::uint32_t;

inline constexpr RtpsEntity kSpdpWriter = 0x000100c2, kPublicationsWriter = 0x000003c2,
                            kSubscriptionsWriter = 0x000004c2;

/// A UDP address over IPv4, in the host's byte order.
struct RtpsAddress {
  std::uint32_t address = 0;
  std::uint32_t port = 0;
  auto operator<=>(const RtpsAddress&) const = default;
};

/// A sample of discovery data: a participant or an endpoint exists, or has been removed.
struct RtpsDiscovery {
  RtpsEntity writer = 0;
  std::uint64_t sequence = 0;
  std::size_t bytes = 0;
  /// The participant that sends it.
  RtpsPrefix sender{};
  /// Whether it describes an existing one.
  bool isAlive = false;
  /// Whether it announces a removal (its status is disposed or unregistered). If neither is true, it has no content.
  bool isGone = false;
  /// Of the participant, or of the participant that has the endpoint; unset if the sample does not contain it.
  std::optional<RtpsPrefix> prefix;
  /// The participant's addresses for discovery data, and all its addresses.
  std::vector<RtpsAddress> discoveryAddresses, addresses;
  /// Lease duration; a negative one is read as unsigned. Of several, the last.
  std::optional<std::chrono::nanoseconds> lease;
  /// Offsets of the leases in the message: 4 bytes of seconds, then 4 of their fraction.
  std::vector<std::size_t> leasesAt;
  /// Byte order of the description.
  bool isLittleEndian = true;
  /// Whether its endpoints include the writer of participants (SPDP). Without it Fast DDS ignores its end.
  bool announcesItself = false;
  /// Of a participant: its name, and its user data, which in nodes of ROS is a list such as "enclave=/;".
  std::string name, userData;

  /// @return Whether it is about a participant, and not about an endpoint.
  bool isOfParticipant() const { return writer == kSpdpWriter; }
  /// @return The participant that it is about; the sender if it does not contain one.
  const RtpsPrefix& participant() const { return prefix ? *prefix : sender; }
};

// pongsim's own topics and those of its node in ROS never match, so the participants of either ignore the others', in
// all processes and on both sides: with the same domain they would tell each other of all their endpoints in vain,
// which takes a time that grows with the square of their number. What marks them:

/// How the names of the participants with pongsim's own topics begin.
inline constexpr std::string_view kPongsimName = "pongsim/";
/// In the user data of participants that are nodes of ROS in a simulation.
inline constexpr std::string_view kPongsimRosMark = "pongsim=ros2;";

/// @return Whether a sample announces a participant of that kind.
bool isOfPongsim(const RtpsDiscovery& sample);
bool isOfPongsimRos(const RtpsDiscovery& sample);

/// A heartbeat of a discovery writer.
struct RtpsHeartbeat {
  RtpsEntity writer = 0;
  /// The sequence number of its last sample.
  std::uint64_t last = 0;
};

/// An ACKNACK of the reader that belongs to a discovery writer.
struct RtpsAcknowledgement {
  RtpsEntity writer = 0;
  /// All sequence numbers below this one have been received.
  std::uint64_t below = 0;
  /// Increases with each ACKNACK of the same reader.
  std::uint32_t count = 0;

  bool operator==(const RtpsAcknowledgement&) const = default;
};

/// The parts of an RTPS message (RTPS 2.3, 8.3 and 9.4) that change the receiver's state or cost it memory and time.
struct RtpsMessage {
  RtpsPrefix source{};
  /// Further participants in INFO_SRC submessages: those of one process of Cyclone DDS may share a message.
  std::vector<RtpsPrefix> otherSources;
  std::vector<RtpsDiscovery> discovery;
  /// Whether it contains a participant's sample that could not be read: fragmented or malformed.
  bool hasUnreadParticipant = false;
  /// Whether its lengths are valid, and it contains nothing that Fast DDS and pongsim never send: other sources,
  /// fragmented discovery data, fragments beyond the end of their sample, sets of more than 256 numbers, gaps that end
  /// before they begin, sequence numbers above 2^48, a negative count of an ACKNACK.
  bool isProper = true;
  /// Number of sequence numbers in its GAP submessages.
  std::uint64_t gapNumbers = 0;
  /// Number of submessages that request samples again.
  std::size_t repeatRequests = 0;
  /// Size of the largest sample of which it contains a fragment [bytes].
  std::uint64_t largestFragmented = 0;
  /// Number of submessages that are neither discovery data, nor heartbeats of discovery writers, nor INFO_*.
  std::size_t others = 0;
  std::vector<RtpsHeartbeat> heartbeats;
  std::vector<RtpsAcknowledgement> acknowledgements;
  /// Whether it has one destination participant (INFO_DST).
  bool isAddressed = false;

  /// @return Whether it is the announcement of its sender, and nothing else.
  bool isAnnouncement() const {
    return discovery.size() == 1 && discovery.front().isOfParticipant() && discovery.front().isAlive &&
           discovery.front().prefix == source && others == 0 && heartbeats.empty();
  }

  /// @return Whether it consists of heartbeats of discovery writers to all participants.
  bool isHeartbeatToAll() const { return !heartbeats.empty() && !isAddressed && discovery.empty() && others == 0; }
};

/// @return The parts that could be read; nothing if the bytes are no RTPS message.
std::optional<RtpsMessage> readAnyRtpsMessage(std::span<const std::uint8_t> bytes);

/// @return The message; nothing if it is not proper (`RtpsMessage::isProper`).
std::optional<RtpsMessage> readRtpsMessage(std::span<const std::uint8_t> bytes);

/// @param sequence Of the sample.
/// @return An announcement in the participant's name that contains only a lease of zero.
std::vector<std::uint8_t> announcementWithoutLease(const RtpsPrefix& participant, std::uint64_t sequence);

/// @param number Must be higher with each call, because Fast DDS drops samples that are not newer.
/// @return A message that announces the participant's end in its name. Its sequence number is above all that
/// `readAnyRtpsMessage` accepts.
std::vector<std::uint8_t> goodbyeBy(const RtpsPrefix& participant, std::uint64_t number);

/// @return A message with ACKNACKs in the participant's name that request nothing.
std::vector<std::uint8_t> acknowledgementBy(const RtpsPrefix& participant,
                                            std::span<const RtpsAcknowledgement> acknowledgements);

}  // namespace pongsim::shared
