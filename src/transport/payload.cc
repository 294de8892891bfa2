#include "transport/payload.hh"

#include <algorithm>
#include <cstdint>

namespace pongsim::transport {

namespace {

constexpr std::byte kBigEndian{0};
constexpr std::byte kLittleEndian{1};

// In the first byte of the options: XTypes uses the last two bits of the options (7.6.3.1.2); the others are free.
constexpr std::size_t kOptions = 2;
constexpr std::byte kKeptOption{0x40};
constexpr std::byte kAgainOption{0x80};

}  // namespace

std::span<std::byte> framePayload(std::span<std::byte> payload, std::size_t messageSize, Keeping keeping) {
  payload[0] = std::byte{0};
  payload[1] = kLittleEndian;
  payload[kOptions] = keeping == Keeping::kNone ? std::byte{0} : kKeptOption;
  payload[3] = std::byte{0};
  for (std::size_t i = 0; i < 4; ++i) payload[4 + i] = static_cast<std::byte>(messageSize >> (8 * i));
  std::ranges::fill(payload.subspan(kPayloadHeader + messageSize), std::byte{0});
  return payload.subspan(kPayloadHeader, messageSize);
}

void markAsAgain(std::span<std::byte> payload) { payload[kOptions] |= kAgainOption; }

Keeping keepingOf(std::span<const std::byte> payload) {
  if (payload.size() < kPayloadHeader || (payload[kOptions] & kKeptOption) == std::byte{0}) return Keeping::kNone;
  return (payload[kOptions] & kAgainOption) == std::byte{0} ? Keeping::kKept : Keeping::kAgain;
}

std::optional<std::span<const std::byte>> messageInPayload(std::span<const std::byte> payload) {
  if (payload.size() < kPayloadHeader || payload[0] != std::byte{0}) return std::nullopt;
  if (payload[1] != kBigEndian && payload[1] != kLittleEndian) return std::nullopt;
  std::size_t messageSize = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t shift = payload[1] == kLittleEndian ? 8 * i : 8 * (3 - i);
    messageSize |= static_cast<std::size_t>(payload[4 + i]) << shift;
  }
  if (payload.size() != payloadSize(messageSize)) return std::nullopt;
  return payload.subspan(kPayloadHeader, messageSize);
}

}  // namespace pongsim::transport
