#include "ros2/wire/discovery_acknacks.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace pongsim::ros2 {
namespace {

using Packet = std::vector<unsigned char>;

constexpr shared::RtpsPrefix kReader = {1, 16, 7}, kOtherReader = {1, 16, 8};

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

TEST(DiscoveryAcknacks, OfDiscoveryAsksFromZeroOn) {
  for (const bool isLittle : {true, false}) {
    for (const unsigned char entity : {static_cast<unsigned char>(3), static_cast<unsigned char>(4)}) {
      Packet packet = message({.writer = {0, 0, entity, 0xc2}, .isLittle = isLittle});
      EXPECT_EQ(DiscoveryAcknacks().modify(kReader, packet), 1U);
      EXPECT_EQ(packet, message({.writer = {0, 0, entity, 0xc2}, .first = 0, .count = 1, .isLittle = isLittle}));
    }
  }
}

TEST(DiscoveryAcknacks, OfLaterOnesOnlyTheCountIsOther) {
  DiscoveryAcknacks acknacks;
  std::uint32_t count = 0;
  for (const Asked& asked :
       {Asked{.first = 0, .count = 5}, Asked{.bits = 1, .count = 1}, Asked{.first = 2}, Asked{.isFinal = true}}) {
    Packet packet = message(asked);
    EXPECT_EQ(acknacks.modify(kReader, packet), 0U);
    Asked expected = asked;
    expected.count = ++count;
    EXPECT_EQ(packet, message(expected));
  }
}

TEST(DiscoveryAcknacks, OfWhoAsksAgainAskFromZeroOn) {
  DiscoveryAcknacks acknacks;
  Packet all = message({.first = 47, .count = 9});
  acknacks.modify(kReader, all);
  // another one's count for themselves
  Packet other = message({.bits = 1});
  EXPECT_EQ(acknacks.modify(kOtherReader, other), 0U);
  Packet packet = message({.bits = 1, .count = 2});
  EXPECT_EQ(acknacks.modify(kReader, packet), 1U);
  Packet expected = message({.first = 0, .bits = 0, .count = 3});
  // the bits that are no more, and the former count
  expected[38] = 28;
  put(expected, 2, true);
  EXPECT_EQ(packet, expected);
  // from now on it asks for what it lacks
  packet = message({.bits = 1, .count = 3});
  EXPECT_EQ(acknacks.modify(kReader, packet), 0U);
  acknacks.modify(kReader, all);
  acknacks.forget(kReader);
  packet = message({.bits = 1});
  EXPECT_EQ(acknacks.modify(kReader, packet), 0U);
}

TEST(DiscoveryAcknacks, OfOtherWritersIsLeftAlone) {
  const Asked asked{.writer = {0, 0, 1, 3}};
  Packet packet = message(asked);
  EXPECT_EQ(DiscoveryAcknacks().modify(kReader, packet), 0U);
  EXPECT_EQ(packet, message(asked));
}

TEST(DiscoveryAcknacks, IsNotLookedForBehindTheEnd) {
  const Packet whole = message({});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    // allocated with the exact size, so that a sanitizer detects reads beyond it
    Packet packet(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(DiscoveryAcknacks().modify(kReader, packet), 0U) << size;
  }
  std::mt19937 chance(3);
  for (int i = 0; i < 20000; ++i) {
    Packet packet = whole;
    packet.resize(20 + chance() % (packet.size() - 19));
    for (int j = 0; j < 3; ++j) packet[chance() % packet.size()] = static_cast<unsigned char>(chance());
    EXPECT_LE(DiscoveryAcknacks().modify(kReader, packet), 2U);
  }
}

}  // namespace
}  // namespace pongsim::ros2
