#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace pongsim::transport {

/// A message as a DDS sample: the CDR form of a sequence of octets (OMG DDSI-RTPS 10.2.1.2, CORBA 9.3.2.7), because
/// DDS pads samples to four bytes and a message must know its own length. Its bytes come after this many.
inline constexpr std::size_t kPayloadHeader = 8;

/// A larger message is not sent.
inline constexpr std::size_t kMaximumMessage = 1 << 30;

/// @return The size of the sample for a message of so many bytes.
constexpr std::size_t payloadSize(std::size_t messageSize) { return kPayloadHeader + (messageSize + 3) / 4 * 4; }

/// What a sample is to who comes late. Told in the sample's options, which other programs do not look at.
enum class Keeping {
  /// Nothing.
  kNone,
  /// It is kept, and sent again to who comes later.
  kKept,
  /// It is one that was kept: whoever has heard its writer before has it already.
  kAgain
};

/// Fills in all of a sample of `payloadSize(messageSize)` bytes but for the message itself.
/// @return Where the message belongs.
std::span<std::byte> framePayload(std::span<std::byte> payload, std::size_t messageSize,
                                  Keeping keeping = Keeping::kNone);

/// Says of a framed sample that it is sent again.
void markAsAgain(std::span<std::byte> payload);

/// @return What a sample of any bytes is; nothing special where it is not framed.
Keeping keepingOf(std::span<const std::byte> payload);

/// @return The message in a sample, or nothing where it is not framed as above.
std::optional<std::span<const std::byte>> messageInPayload(std::span<const std::byte> payload);

}  // namespace pongsim::transport
