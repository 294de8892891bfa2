#include "ros2/wire/first_acknack.hh"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pongsim::ros2 {

namespace {

// RTPS 2.3: 9.4.1 header, 9.4.5.1 submessages, 9.4.5.3 ACKNACK, 9.3.1.3 entities
constexpr std::array<unsigned char, 4> kProtocol{'R', 'T', 'P', 'S'};
constexpr std::size_t kHeader = 20, kSubmessageHeader = 4;
constexpr unsigned char kAcknack = 0x06, kPad = 0x01, kInfoTimestamp = 0x09;
constexpr unsigned char kLittleEndian = 0x01, kFinal = 0x02;
// offsets: writer, first requested number (high and low half), number of bits, and the smallest size
constexpr std::size_t kWriter = 4, kFirstHigh = 8, kFirstLow = 12, kBits = 16, kLeast = 24;
constexpr std::uint32_t kMostBits = 256;
constexpr std::array<unsigned char, 4> kPublications{0, 0, 3, 0xc2}, kSubscriptions{0, 0, 4, 0xc2};

std::uint32_t numberAt(std::span<const unsigned char> bytes, std::size_t at, bool isLittle) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | bytes[at + (isLittle ? 3 - i : i)];
  return number;
}

void putNumber(std::span<unsigned char> bytes, std::size_t at, bool isLittle, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + (isLittle ? i : 3 - i)] = static_cast<unsigned char>(number >> 8 * i);
}

bool isForDiscovery(std::span<const unsigned char> content) {
  if (content.size() < kLeast) return false;
  const auto writer = content.subspan(kWriter, 4);
  return std::ranges::equal(writer, kPublications) || std::ranges::equal(writer, kSubscriptions);
}

/// @return Whether it is a first request.
bool hasten(std::span<unsigned char> content, unsigned char flags) {
  if (!isForDiscovery(content)) return false;
  const bool isLittle = (flags & kLittleEndian) != 0;
  const std::uint32_t bits = numberAt(content, kBits, isLittle);
  if (bits > kMostBits) return false;
  const std::size_t count = kBits + 4 + 4 * ((bits + 31) / 32);
  if (count + 4 > content.size()) return false;
  putNumber(content, count, isLittle, numberAt(content, count, isLittle) + 1);
  if ((flags & kFinal) != 0 || bits > 0 || numberAt(content, kFirstHigh, isLittle) != 0 ||
      numberAt(content, kFirstLow, isLittle) != 1) {
    return false;
  }
  putNumber(content, kFirstLow, isLittle, 0);
  return true;
}

}  // namespace

std::size_t hastenFirstAcknacks(std::span<unsigned char> packet) {
  if (packet.size() < kHeader || !std::ranges::equal(packet.first(kProtocol.size()), kProtocol)) return 0;
  std::size_t count = 0;
  std::span<unsigned char> rest = packet.subspan(kHeader);
  while (rest.size() >= kSubmessageHeader) {
    const unsigned char kind = rest[0], flags = rest[1];
    const bool isLittle = (flags & kLittleEndian) != 0;
    std::size_t size =
        static_cast<std::size_t>(rest[isLittle ? 2 : 3]) | static_cast<std::size_t>(rest[isLittle ? 3 : 2]) << 8;
    rest = rest.subspan(kSubmessageHeader);
    // a size of zero means up to the end of the packet
    if (size == 0 && kind != kPad && kind != kInfoTimestamp) size = rest.size();
    if (size > rest.size()) break;
    if (kind == kAcknack && hasten(rest.first(size), flags)) ++count;
    rest = rest.subspan(size);
  }
  return count;
}

}  // namespace pongsim::ros2
