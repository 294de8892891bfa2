#include "ros2/wire/discovery_acknacks.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "shared/rtps/wire_number.hh"

namespace pongsim::ros2 {

namespace {

// RTPS 2.3: 9.4.5.1 submessages, 9.4.5.3 ACKNACK, 9.3.1.3 entities
constexpr std::uint8_t kAcknack = 0x06, kFinal = 0x02;
// offsets: writer, first requested number (high and low half), number of bits, bits, and the smallest size
constexpr std::size_t kWriter = 4, kFirstHigh = 8, kFirstLow = 12, kBits = 16, kBitmap = 20, kLeast = 24;
constexpr std::uint64_t kMostBits = 256;
constexpr std::array<std::array<std::uint8_t, 4>, 2> kDiscoveryWriters{{{0, 0, 3, 0xc2}, {0, 0, 4, 0xc2}}};

/// @return The index of the discovery writer that an ACKNACK is for.
std::optional<std::size_t> discoveryWriterOf(std::span<const std::uint8_t> content) {
  if (content.size() < kLeast) return std::nullopt;
  for (std::size_t i = 0; i < kDiscoveryWriters.size(); ++i) {
    if (std::ranges::equal(content.subspan(kWriter, 4), kDiscoveryWriters[i])) return i;
  }
  return std::nullopt;
}

}  // namespace

/// @param content Of the ACKNACK `part`.
/// @return Whether it asks from 0 on now.
bool DiscoveryAcknacks::modify(std::uint64_t& acknowledged, const shared::Submessage& part,
                               std::span<std::uint8_t> content) {
  const bool isLittle = part.isLittleEndian();
  const auto numberAt = [&](std::size_t at) { return shared::readNumber(part.content.subspan(at, 4), isLittle); };
  const auto write = [&](std::uint64_t number, std::size_t at) {
    shared::writeNumber(number, content.subspan(at, 4), isLittle);
  };
  const std::uint64_t bits = numberAt(kBits);
  if (bits > kMostBits) return false;
  std::size_t count = kBitmap + 4 * ((bits + 31) / 32);
  if (count + 4 > content.size()) return false;
  const std::uint64_t first = numberAt(kFirstHigh) << 32 | numberAt(kFirstLow);
  const bool isFinal = (part.flags & kFinal) != 0;
  const bool isFirst = first == 1 && bits == 0 && !isFinal;
  const bool isAgain = first < std::exchange(acknowledged, first) && first > 0 && !isFinal;
  if (isFirst || isAgain) {
    write(0, kFirstHigh);
    write(0, kFirstLow);
    write(0, kBits);
    count = kBitmap;
  }
  write(++count_, count);
  return isFirst || isAgain;
}

std::size_t DiscoveryAcknacks::modify(const shared::RtpsPrefix& source, std::span<std::uint8_t> packet) {
  std::size_t found = 0;
  shared::Submessages parts(packet);
  while (const auto part = parts.next()) {
    if (part->kind != kAcknack) continue;
    const auto at = static_cast<std::size_t>(part->content.data() - packet.data());
    const auto content = packet.subspan(at, part->content.size());
    const std::optional<std::size_t> writer = discoveryWriterOf(content);
    if (writer && modify(acknowledged_[source][*writer], *part, content)) ++found;
  }
  return found;
}

}  // namespace pongsim::ros2
