#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace pongsim::transport {

/// A message as a DDS sample: a CDR sequence of octets (OMG DDSI-RTPS 10.2.1.2, CORBA 9.3.2.7), because DDS pads
/// samples to four bytes and a message needs its exact length. The message follows after this many bytes.
inline constexpr std::size_t kPayloadHeader = 8;

/// Larger messages are not sent: a receiver needs memory for a whole message with its first fragment.
inline constexpr std::size_t kMaximumMessage = 64 << 20;

/// @return The size of the sample for a message of that size.
constexpr std::size_t payloadSize(std::size_t messageSize) { return kPayloadHeader + (messageSize + 3) / 4 * 4; }

/// How a sample relates to later readers. Part of the sample's options, which other programs ignore.
enum class Keeping {
  /// Not kept.
  kNone,
  /// Kept, and sent again to later readers.
  kKept,
  /// A kept sample sent again: readers that know its writer already have it.
  kAgain
};

/// Fills in everything of a sample of `payloadSize(messageSize)` bytes but the message.
/// @return The place for the message.
std::span<std::byte> framePayload(std::span<std::byte> payload, std::size_t messageSize,
                                  Keeping keeping = Keeping::kNone);

/// Marks a framed sample as sent again.
void markAsAgain(std::span<std::byte> payload);

/// @return Whether and how a sample was kept; `kNone` if it is not framed.
Keeping keepingOf(std::span<const std::byte> payload);

/// @return The message in a sample; nothing if it is not framed as above.
std::optional<std::span<const std::byte>> messageInPayload(std::span<const std::byte> payload);

}  // namespace pongsim::transport
