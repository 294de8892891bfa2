#include "ros2/wire/first_acknack.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace pongsim::ros2 {
namespace {

using Packet = std::vector<unsigned char>;

struct Asked {
  std::array<unsigned char, 4> writer{0, 0, 3, 0xc2};
  std::uint32_t first = 1;
  std::uint32_t bits = 0;
  std::uint32_t count = 0;
  bool isFinal = false;
  bool isLittle = true;
};

void put(Packet& packet, std::uint32_t number, bool isLittle) {
  for (int i = 0; i < 4; ++i) packet.push_back(static_cast<unsigned char>(number >> 8 * (isLittle ? i : 3 - i)));
}

/// A message with another submessage before the ACKNACK, like Cyclone's.
Packet message(const Asked& asked) {
  Packet packet{'R', 'T', 'P', 'S', 2, 1, 1, 16};
  packet.resize(20, 7);
  // INFO_DST
  packet.insert(packet.end(), {0x0e, 1, 12, 0});
  packet.resize(packet.size() + 12, 9);
  const unsigned char flags = (asked.isLittle ? 1 : 0) | (asked.isFinal ? 2 : 0);
  const unsigned char size = asked.bits > 0 ? 28 : 24;
  packet.insert(packet.end(), {0x06, flags, asked.isLittle ? size : static_cast<unsigned char>(0),
                               asked.isLittle ? static_cast<unsigned char>(0) : size});
  packet.insert(packet.end(), {0, 0, 3, 0xc7});
  packet.insert(packet.end(), asked.writer.begin(), asked.writer.end());
  put(packet, 0, asked.isLittle);
  put(packet, asked.first, asked.isLittle);
  put(packet, asked.bits, asked.isLittle);
  if (asked.bits > 0) put(packet, 0x80000000, asked.isLittle);
  put(packet, asked.count, asked.isLittle);
  return packet;
}

TEST(FirstAcknack, OfDiscoveryAsksFromZeroOn) {
  for (const bool isLittle : {true, false}) {
    for (const unsigned char entity : {static_cast<unsigned char>(3), static_cast<unsigned char>(4)}) {
      Packet packet = message({.writer = {0, 0, entity, 0xc2}, .isLittle = isLittle});
      EXPECT_EQ(hastenFirstAcknacks(packet), 1U);
      EXPECT_EQ(packet, message({.writer = {0, 0, entity, 0xc2}, .first = 0, .count = 1, .isLittle = isLittle}));
    }
  }
}

TEST(FirstAcknack, OfLaterOnesOnlyTheCountIsMore) {
  for (const Asked& asked :
       {Asked{.first = 2}, Asked{.bits = 1, .count = 1}, Asked{.isFinal = true}, Asked{.first = 0}}) {
    Packet packet = message(asked);
    EXPECT_EQ(hastenFirstAcknacks(packet), 0U);
    Asked expected = asked;
    ++expected.count;
    EXPECT_EQ(packet, message(expected));
  }
}

TEST(FirstAcknack, OfOtherWritersIsLeftAlone) {
  const Asked asked{.writer = {0, 0, 1, 3}};
  Packet packet = message(asked);
  EXPECT_EQ(hastenFirstAcknacks(packet), 0U);
  EXPECT_EQ(packet, message(asked));
}

TEST(FirstAcknack, IsNotLookedForBehindTheEnd) {
  const Packet whole = message({});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    // allocated with the exact size, so that a sanitizer detects reads beyond it
    Packet packet(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(hastenFirstAcknacks(packet), 0U) << size;
  }
  std::mt19937 chance(3);
  for (int i = 0; i < 20000; ++i) {
    Packet packet = whole;
    packet.resize(20 + chance() % (packet.size() - 19));
    for (int j = 0; j < 3; ++j) packet[chance() % packet.size()] = static_cast<unsigned char>(chance());
    EXPECT_LE(hastenFirstAcknacks(packet), 2U);
  }
}

}  // namespace
}  // namespace pongsim::ros2
