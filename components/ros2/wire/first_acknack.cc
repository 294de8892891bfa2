#include "ros2/wire/first_acknack.hh"

#include <algorithm>
#include <array>
#include <cstdint>

#include "ros2/wire/submessages.hh"

namespace pongsim::ros2 {

namespace {

// RTPS 2.3: 9.4.5.1 submessages, 9.4.5.3 ACKNACK, 9.3.1.3 entities
constexpr unsigned char kAcknack = 0x06, kFinal = 0x02;
// offsets: writer, first requested number (high and low half), number of bits, and the smallest size
constexpr std::size_t kWriter = 4, kFirstHigh = 8, kFirstLow = 12, kBits = 16, kLeast = 24;
constexpr std::uint64_t kMostBits = 256;
constexpr std::array<unsigned char, 4> kPublications{0, 0, 3, 0xc2}, kSubscriptions{0, 0, 4, 0xc2};

bool isForDiscovery(std::span<const unsigned char> content) {
  if (content.size() < kLeast) return false;
  const auto writer = content.subspan(kWriter, 4);
  return std::ranges::equal(writer, kPublications) || std::ranges::equal(writer, kSubscriptions);
}

/// @return Whether it is a first request.
bool hasten(const Submessage& acknack) {
  const std::span<unsigned char> content = acknack.content;
  if (!isForDiscovery(content)) return false;
  const bool isLittle = acknack.isLittleEndian();
  const auto numberAt = [&](std::size_t at) { return numberIn(content.subspan(at, 4), isLittle); };
  const std::uint64_t bits = numberAt(kBits);
  if (bits > kMostBits) return false;
  const std::size_t count = kBits + 4 + 4 * ((bits + 31) / 32);
  if (count + 4 > content.size()) return false;
  putNumber(content.subspan(count, 4), isLittle, numberAt(count) + 1);
  if ((acknack.flags & kFinal) != 0 || bits > 0 || numberAt(kFirstHigh) != 0 || numberAt(kFirstLow) != 1) return false;
  putNumber(content.subspan(kFirstLow, 4), isLittle, 0);
  return true;
}

}  // namespace

std::size_t hastenFirstAcknacks(std::span<unsigned char> packet) {
  std::size_t count = 0;
  Submessages parts(packet);
  while (const auto part = parts.next()) {
    if (part->kind == kAcknack && hasten(*part)) ++count;
  }
  return count;
}

}  // namespace pongsim::ros2
