#include "pongsim/program/neighbour_leases.hh"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "hostile/packet.hh"
#include "transport/rtps_message.hh"

namespace pongsim {

namespace {

using hostile::Kind;
using hostile::Packet;
using std::chrono::seconds;

constexpr NeighbourLeases::Prefix kNeighbour = {1, 15, 7}, kOther = {1, 16, 8};

/// A sample of discovery without its content.
Packet begin(const NeighbourLeases::Prefix& source, std::uint8_t flags, transport::RtpsEntity writer,
             std::int64_t sequence = 1) {
  Packet packet(source);
  packet.begin(Kind::kData, flags);
  packet.add16(0);
  packet.add16(16);
  packet.addEntity(0);
  packet.addEntity(writer);
  packet.addSequence(sequence);
  return packet;
}

/// @param of Whose announcement it is.
/// @param lease In seconds; unset: it has none.
std::vector<std::uint8_t> announcement(const NeighbourLeases::Prefix& source, const NeighbourLeases::Prefix& of,
                                       std::optional<std::uint32_t> lease, std::int64_t sequence = 1) {
  constexpr std::uint8_t kWithData = 4;
  Packet packet = begin(source, kWithData, transport::kSpdpWriter, sequence);
  packet.add32(0x00000300);
  packet.addGuid(0x50, of, 0x1c1);
  if (lease) {
    packet.beginParameter(0x02);
    packet.add32(*lease);
    packet.add32(0);
    packet.endParameter();
  }
  packet.addSentinel();
  packet.end();
  return {packet.bytes().begin(), packet.bytes().end()};
}

class NeighbourLeasesTest : public testing::Test {
 protected:
  bool admits(std::vector<std::uint8_t> message) { return leases_.admits(message, now_); }
  bool admits(const Packet& packet) { return admits({packet.bytes().begin(), packet.bytes().end()}); }

  NeighbourLeases leases_;
  NeighbourLeases::TimePoint now_ = NeighbourLeases::TimePoint(std::chrono::hours(1));
};

TEST_F(NeighbourLeasesTest, AreEndlessForFastDdsAndEndInItsPlace) {
  std::vector<std::uint8_t> message = announcement(kNeighbour, kNeighbour, 5);
  ASSERT_TRUE(leases_.admits(message, now_));
  const auto at = transport::readRtpsMessage(message)->discovery.at(0).leaseAt;
  ASSERT_TRUE(at);
  EXPECT_GE(message[*at + 3], 0x40) << "2^30 seconds or more";
  leases_.discovered(kNeighbour, now_);

  now_ += seconds(5);
  EXPECT_TRUE(leases_.endings(now_).messages.empty());
  EXPECT_GT(leases_.endings(now_).nextLook, now_);
  EXPECT_LE(leases_.endings(now_).nextLook, now_ + seconds(1));
  now_ = leases_.endings(now_).nextLook;
  const auto messages = leases_.endings(now_).messages;
  ASSERT_EQ(messages.size(), 1);
  const auto ending = transport::readRtpsMessage(messages.front());
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->source, kNeighbour);

  EXPECT_FALSE(admits(announcement(kNeighbour, kNeighbour, 5, 2))) << "it is not yet dropped";
  leases_.removed(kNeighbour);
  EXPECT_TRUE(admits(announcement(kNeighbour, kNeighbour, 5, 3))) << "it is back";
}

TEST_F(NeighbourLeasesTest, RefuseWhatNoHonestParticipantSends) {
  EXPECT_FALSE(admits({1, 2, 3}));
  EXPECT_FALSE(admits(announcement(kNeighbour, kOther, 20))) << "in the name of another one";
  EXPECT_FALSE(admits(announcement(kNeighbour, kNeighbour, std::nullopt))) << "without a lease";
  EXPECT_FALSE(admits(announcement(kNeighbour, kNeighbour, 20, std::numeric_limits<std::int64_t>::max())));
  EXPECT_TRUE(admits(announcement(kNeighbour, kNeighbour, 20)));
}

TEST_F(NeighbourLeasesTest, LetByAGoodbyeThatNamesItselfInItsContent) {
  // that of Cyclone DDS: no hash of the key, but the key
  constexpr std::uint8_t kInlineQos = 2, kWithKey = 8;
  Packet packet = begin(kNeighbour, kInlineQos | kWithKey, transport::kSpdpWriter);
  packet.addNumberParameter(0x71, 0x03000000);
  packet.addSentinel();
  packet.add32(0x00000300);
  packet.addGuid(0x50, kNeighbour, 0x1c1);
  packet.addSentinel();
  packet.end();
  EXPECT_TRUE(admits(packet));
}

TEST_F(NeighbourLeasesTest, LetByEndpointsInFragmentsButNoParticipants) {
  const auto fragment = [&](transport::RtpsEntity writer) {
    Packet packet(kNeighbour);
    packet.begin(Kind::kDataFrag);
    packet.add16(0);
    packet.add16(28);
    packet.addEntity(0);
    packet.addEntity(writer);
    packet.addSequence(1);
    packet.add32(1);
    packet.add16(1);
    packet.add16(64);
    packet.add32(1000);
    packet.addZeros(64);
    packet.end();
    return admits(packet);
  };
  EXPECT_TRUE(fragment(transport::kPublicationsWriter));
  EXPECT_FALSE(fragment(transport::kSpdpWriter)) << "whose lease could not be read";
}

TEST_F(NeighbourLeasesTest, AreThoseOf512Neighbours) {
  const auto announce = [&](std::uint32_t number) {
    NeighbourLeases::Prefix prefix = kNeighbour;
    prefix[10] = static_cast<std::uint8_t>(number >> 8);
    prefix[11] = static_cast<std::uint8_t>(number);
    return admits(announcement(prefix, prefix, 20));
  };
  for (std::uint32_t i = 0; i < 512; ++i) ASSERT_TRUE(announce(i)) << i;
  EXPECT_FALSE(announce(512));
  EXPECT_TRUE(announce(511)) << "which is known";
  leases_.removed(kNeighbour);
  EXPECT_TRUE(announce(512));
}

}  // namespace

}  // namespace pongsim
