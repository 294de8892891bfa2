#include "ros2/wire/first_acknack.hh"

#include <algorithm>
#include <array>
#include <cstdint>

#include "shared/rtps/submessages.hh"
#include "shared/rtps/wire_number.hh"

namespace pongsim::ros2 {

namespace {

// RTPS 2.3: 9.4.5.1 submessages, 9.4.5.3 ACKNACK, 9.3.1.3 entities
constexpr std::uint8_t kAcknack = 0x06, kFinal = 0x02;
// offsets: writer, first requested number (high and low half), number of bits, and the smallest size
constexpr std::size_t kWriter = 4, kFirstHigh = 8, kFirstLow = 12, kBits = 16, kLeast = 24;
constexpr std::uint64_t kMostBits = 256;
constexpr std::array<std::uint8_t, 4> kPublications{0, 0, 3, 0xc2}, kSubscriptions{0, 0, 4, 0xc2};

bool isForDiscovery(std::span<const std::uint8_t> content) {
  if (content.size() < kLeast) return false;
  const auto writer = content.subspan(kWriter, 4);
  return std::ranges::equal(writer, kPublications) || std::ranges::equal(writer, kSubscriptions);
}

/// @param content Of the ACKNACK `part`.
/// @return Whether it is a first request.
bool hasten(const shared::Submessage& part, std::span<std::uint8_t> content) {
  if (!isForDiscovery(content)) return false;
  const bool isLittle = part.isLittleEndian();
  const auto numberAt = [&](std::size_t at) { return shared::readNumber(part.content.subspan(at, 4), isLittle); };
  const std::uint64_t bits = numberAt(kBits);
  if (bits > kMostBits) return false;
  const std::size_t count = kBits + 4 + 4 * ((bits + 31) / 32);
  if (count + 4 > content.size()) return false;
  shared::writeNumber(numberAt(count) + 1, content.subspan(count, 4), isLittle);
  if ((part.flags & kFinal) != 0 || bits > 0 || numberAt(kFirstHigh) != 0 || numberAt(kFirstLow) != 1) return false;
  shared::writeNumber(0, content.subspan(kFirstLow, 4), isLittle);
  return true;
}

}  // namespace

std::size_t hastenFirstAcknacks(std::span<std::uint8_t> packet) {
  std::size_t count = 0;
  shared::Submessages parts(packet);
  while (const auto part = parts.next()) {
    if (part->kind != kAcknack) continue;
    const auto at = static_cast<std::size_t>(part->content.data() - packet.data());
    if (hasten(*part, packet.subspan(at, part->content.size()))) ++count;
  }
  return count;
}

}  // namespace pongsim::ros2
