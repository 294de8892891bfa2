#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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

/// A sample of discovery: that a participant or an endpoint is there, or has gone.
struct RtpsDiscovery {
  RtpsEntity writer = 0;
  std::uint64_t sequence = 0;
  std::size_t bytes = 0;
  /// Whose submessage it is.
  RtpsPrefix sender{};
  /// Whether it describes what is there.
  bool isAlive = false;
  /// Whether it says that something has gone (its status is disposed or unregistered). If neither, it says nothing.
  bool isGone = false;
  /// Of the participant, or of the participant whose endpoint it is; unset if the sample does not say.
  std::optional<RtpsPrefix> prefix;
  /// Where the participant listens for others, and all its addresses.
  std::vector<RtpsAddress> discoveryAddresses, addresses;
  /// How long the participant may be silent; a negative duration is read as an unsigned one. Of several, the last.
  std::optional<std::chrono::nanoseconds> lease;
  /// Where in the message the leases are: 4 bytes of seconds, then 4 of their fraction.
  std::vector<std::size_t> leasesAt;
  /// The byte order of what describes it.
  bool isLittleEndian = true;
  /// Whether its endpoints include the writer of participants, without which Fast DDS hears no goodbye of it.
  bool announcesItself = false;

  /// @return Whether it is of a participant, rather than of an endpoint.
  bool isOfParticipant() const { return writer == kSpdpWriter; }
  /// @return Whose it is: who sent it if it does not say.
  const RtpsPrefix& participant() const { return prefix ? *prefix : sender; }
};

/// A heartbeat of one of discovery's writers.
struct RtpsHeartbeat {
  RtpsEntity writer = 0;
  /// The sequence number of its last sample.
  std::uint64_t last = 0;
};

/// What the reader of one of discovery's writers has received.
struct RtpsAcknowledgement {
  RtpsEntity writer = 0;
  /// Sequence numbers below this one.
  std::uint64_t below = 0;
  /// Increases from one to the next of the same reader.
  std::uint32_t count = 0;

  bool operator==(const RtpsAcknowledgement&) const = default;
};

/// What an RTPS message (RTPS 2.3, 8.3 and 9.4) demands of its receiver.
struct RtpsMessage {
  RtpsPrefix source{};
  /// Other participants in whose names it goes on: those of one process by Cyclone DDS may share a message.
  std::vector<RtpsPrefix> otherSources;
  std::vector<RtpsDiscovery> discovery;
  /// Whether it has a sample of a participant that could not be read: in fragments, or malformed.
  bool hasUnreadParticipant = false;
  /// Whether its lengths are right, and it has nothing that Fast DDS and pongsim never send: other sources, discovery
  /// in fragments, fragments behind the end of their sample, a set of more than 256 numbers, a gap that ends before it
  /// begins, a sequence number beyond 2^48, a negative count of acknowledgements.
  bool isProper = true;
  /// Sequence numbers that it declares to be gaps.
  std::uint64_t gapNumbers = 0;
  /// Submessages that request samples again.
  std::size_t repeatRequests = 0;
  /// The largest sample of which it has a fragment [bytes].
  std::uint64_t largestFragmented = 0;
  /// Submessages that are neither discovery, nor a heartbeat of it, nor about the message itself.
  std::size_t others = 0;
  std::vector<RtpsHeartbeat> heartbeats;
  std::vector<RtpsAcknowledgement> acknowledgements;
  /// Whether it is for one participant.
  bool isAddressed = false;

  /// @return Whether its participant announces itself, and the message contains nothing else.
  bool isAnnouncement() const {
    return discovery.size() == 1 && discovery.front().isOfParticipant() && discovery.front().isAlive &&
           discovery.front().prefix == source && others == 0 && heartbeats.empty();
  }

  /// @return Whether it is heartbeats of discovery for all participants, and contains nothing else.
  bool isHeartbeatToAll() const { return !heartbeats.empty() && !isAddressed && discovery.empty() && others == 0; }
};

/// @return What could be read; nothing if the bytes are no RTPS message.
std::optional<RtpsMessage> readAnyRtpsMessage(std::span<const std::uint8_t> bytes);

/// @return The message; nothing if it is not proper (`RtpsMessage::isProper`).
std::optional<RtpsMessage> readRtpsMessage(std::span<const std::uint8_t> bytes);

/// @param sequence Of the sample.
/// @return A message in which a participant announces a lease of no time, and else nothing of itself.
std::vector<std::uint8_t> announcementWithoutLease(const RtpsPrefix& participant, std::uint64_t sequence);

/// @param number Must be higher each time: Fast DDS drops what is not newer.
/// @return A message in which a participant says goodbye. It is newer than all that `readAnyRtpsMessage` can read.
std::vector<std::uint8_t> goodbyeBy(const RtpsPrefix& participant, std::uint64_t number);

/// @return A message in which a participant acknowledges samples of discovery, and asks for none.
std::vector<std::uint8_t> acknowledgementBy(const RtpsPrefix& participant,
                                            std::span<const RtpsAcknowledgement> acknowledgements);

}  // namespace pongsim::shared
