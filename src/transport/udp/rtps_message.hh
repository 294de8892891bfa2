#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pongsim::transport {

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

/// A sample of discovery, as far as it says whose it is.
struct RtpsDiscovery {
  RtpsEntity writer = 0;
  std::uint64_t sequence = 0;
  std::size_t bytes = 0;
  /// Whether it says that something is there, rather than that it has gone.
  bool isAlive = false;
  /// Of the participant, or of the participant whose endpoint it is; nothing where it is not told.
  std::optional<RtpsPrefix> prefix;
  /// Where the participant listens for others, and all its addresses.
  std::vector<RtpsAddress> discoveryAddresses, addresses;
  /// Where in the message its lease stands, the seconds and then their fraction, and the byte order.
  std::optional<std::size_t> leaseAt;
  bool isLittleEndian = true;

  /// @return Whether it is of a participant, rather than of an endpoint.
  bool isOfParticipant() const { return writer == kSpdpWriter; }
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

/// What an RTPS message (RTPS 2.3, 8.3 and 9.4) asks of who takes it.
struct RtpsMessage {
  RtpsPrefix source{};
  std::vector<RtpsDiscovery> discovery;
  /// Sequence numbers that it declares to be gaps.
  std::uint64_t gapNumbers = 0;
  /// Submessages that want samples again.
  std::size_t wishes = 0;
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

/// @return The message; nothing where its lengths are wrong, or where it says what no honest participant says: that it
/// is from another one than its header says, that discovery comes in fragments, a set of more than 256 numbers, a gap
/// that ends before it begins, a sequence number beyond 2^48, a negative count of acknowledgements.
std::optional<RtpsMessage> readRtpsMessage(std::span<const std::uint8_t> bytes);

/// @param sequence Of the sample.
/// @return A message in which a participant announces a lease of no time, and else nothing of itself.
std::vector<std::uint8_t> announcementWithoutLease(const RtpsPrefix& participant, std::uint64_t sequence);

/// @return A message in which a participant acknowledges samples of discovery, and asks for none.
std::vector<std::uint8_t> acknowledgementBy(const RtpsPrefix& participant,
                                            std::span<const RtpsAcknowledgement> acknowledgements);

}  // namespace pongsim::transport
