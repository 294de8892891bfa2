#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace pongsim::hostile {

/// The participant's part of a GUID (RTPS 2.3, 8.2.4).
using Prefix = std::array<std::uint8_t, 12>;
/// The endpoint's part, most significant byte first: 0x000100c2 is the writer of participants.
using EntityId = std::uint32_t;

namespace entity {
inline constexpr EntityId kParticipant = 0x000001c1, kSpdpWriter = 0x000100c2, kSpdpReader = 0x000100c7,
                          kPublicationsWriter = 0x000003c2, kPublicationsReader = 0x000003c7,
                          kSubscriptionsWriter = 0x000004c2, kSubscriptionsReader = 0x000004c7;
}  // namespace entity

/// Kinds of submessages (RTPS 2.3, 9.4.5.1.1, and DDS-Security 1.1, 7.3.6).
enum class Kind : std::uint8_t {
  kPad = 0x01,
  kAckNack = 0x06,
  kHeartbeat = 0x07,
  kGap = 0x08,
  kInfoTs = 0x09,
  kInfoSrc = 0x0c,
  kInfoDst = 0x0e,
  kNackFrag = 0x12,
  kHeartbeatFrag = 0x13,
  kData = 0x15,
  kDataFrag = 0x16,
  kSecureBody = 0x30,
  kSecurePrefix = 0x31,
  kSecureMessagePrefix = 0x33
};

/// Flags of DATA.
inline constexpr std::uint8_t kInlineQos = 2, kWithData = 4;

/// Builds an RTPS message, little-endian. `begin` and `end`, `beginParameter` and `endParameter` enclose the body of
/// each submessage and parameter, and fill in its length.
class Packet {
 public:
  explicit Packet(const Prefix& source);

  void add8(std::uint8_t number) { bytes_.push_back(number); }
  void add16(std::uint16_t number) { addNumber(number, 2); }
  void add32(std::uint32_t number) { addNumber(number, 4); }
  void addEntity(EntityId id);
  /// Adds a sequence number, upper half first.
  void addSequence(std::int64_t number);
  void addPrefix(const Prefix& prefix) { bytes_.insert(bytes_.end(), prefix.begin(), prefix.end()); }
  void addZeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  /// Adds a set of `bits` sequence numbers, from `base` on, all of them members.
  void addSequenceSet(std::int64_t base, std::uint32_t bits);
  void addBytes(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  /// @param flags In addition to that for little-endian.
  void begin(Kind kind, std::uint8_t flags = 0);
  /// @param length The length in the submessage's header; unset: the true one.
  void end(std::optional<std::uint16_t> length = std::nullopt) { close(length); }
  /// Begins a DATA submessage, up to its lists of parameters.
  void beginData(EntityId reader, EntityId writer, std::int64_t sequence, std::uint8_t flags);

  void beginParameter(std::uint16_t id);
  void endParameter(std::optional<std::uint16_t> length = std::nullopt);
  void addText(std::uint16_t id, std::string_view text);
  void addNumberParameter(std::uint16_t id, std::uint32_t number);
  void addGuid(std::uint16_t id, const Prefix& prefix, EntityId entityId);
  /// A UDP locator over IPv4.
  void addLocator(std::uint16_t id, std::uint32_t address, std::uint32_t port);
  void addSentinel();

  std::size_t size() const { return bytes_.size(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  void addNumber(std::uint64_t number, int size);
  void close(std::optional<std::uint16_t> length);

  std::vector<std::uint8_t> bytes_;
  /// Offsets of the length fields of open submessages and parameters.
  std::vector<std::size_t> open_;
};

/// @return A participant's message that it has gone.
Packet goodbye(const Prefix& prefix);

}  // namespace pongsim::hostile
