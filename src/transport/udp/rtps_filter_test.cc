#include "transport/udp/rtps_filter.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "hostile/packet.hh"

namespace pongsim::transport {

namespace {

using hostile::Kind;
using hostile::Packet;

using RtpsFilter::Side::kNetwork;

constexpr std::uint32_t kLoopback = 0x7f000001, kOtherMachine = 0x0a070701;

RtpsPrefix prefixOf(int number) {
  return {1, 15, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8), 0, 0, 0, 0, 0, 0, 0, 0};
}

/// A filter on a machine with some open sockets; the test sets the time.
class RtpsFilterTest : public testing::Test {
 protected:
  bool accepts(const Packet& packet, const RtpsAddress& from, RtpsFilter::Side side = RtpsFilter::Side::kLoopback) {
    bytes_.assign(packet.bytes().begin(), packet.bytes().end());
    RtpsFilter::Decision decision = filter_.decide(bytes_, from, side, now_);
    before_ = std::move(decision.before);
    return decision.isAccepted;
  }

  static void beginData(Packet& packet, RtpsEntity writer) {
    packet.beginData(0, writer, 1, hostile::kWithData);
    packet.add32(0x00000300);
  }

  static Packet announcement(int number, std::uint32_t address = kLoopback, std::uint32_t lease = 20,
                             std::string_view userData = "") {
    Packet packet(prefixOf(number));
    beginData(packet, shared::kSpdpWriter);
    packet.beginParameter(0x02);
    packet.add32(lease);
    packet.add32(0);
    packet.endParameter();
    packet.addGuid(0x50, prefixOf(number), 0x1c1);
    packet.addLocator(0x32, address, 7410);
    if (!userData.empty()) packet.addText(0x2c, userData);
    packet.addSentinel();
    packet.end();
    return packet;
  }

  static Packet acknowledgement(int number, std::int64_t below, std::uint32_t count) {
    Packet packet(prefixOf(number));
    packet.begin(Kind::kAckNack);
    packet.addEntity(0x000003c7);
    packet.addEntity(shared::kPublicationsWriter);
    packet.addSequenceSet(below, 0);
    packet.add32(count);
    packet.end();
    return packet;
  }

  static Packet goodbye(int number) { return hostile::goodbye(prefixOf(number)); }

  static Packet endpoint(int number, int owner) {
    Packet packet(prefixOf(number));
    beginData(packet, shared::kPublicationsWriter);
    packet.addGuid(0x5a, prefixOf(owner), 0x103);
    packet.addSentinel();
    packet.end();
    return packet;
  }

  std::set<std::uint32_t> discovery_ = {7410};
  std::set<RtpsAddress> open_ = {{kLoopback, 5000}, {kLoopback, 5001}};
  int queries_ = 0;
  RtpsFilter::TimePoint now_{};
  std::vector<std::uint8_t> bytes_;
  /// The message to pass to Fast DDS before the last one.
  std::vector<std::uint8_t> before_;
  RtpsFilter filter_{{[this](std::uint32_t port) {
                        ++queries_;
                        return discovery_.contains(port);
                      },
                      [this](const RtpsAddress& address) { return open_.contains(address); }}};
};

TEST_F(RtpsFilterTest, AcceptsMessagesOfAParticipantOnceItHasAnnouncedItself) {
  EXPECT_FALSE(accepts(endpoint(1, 1), {kLoopback, 5000})) << "before the announcement";
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(accepts(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, DropsMessagesInTheNameOfAnotherParticipant) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
  EXPECT_FALSE(accepts(endpoint(1, 1), {kLoopback, 5001}));
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5001}));
  EXPECT_FALSE(accepts(endpoint(1, 2), {kLoopback, 5000})) << "an endpoint of another participant";
}

TEST_F(RtpsFilterTest, DropsAnnouncementsFromOrOfClosedSockets) {
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 6000})) << "its socket is closed";
  discovery_.clear();
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000})) << "its discovery port is closed";
  discovery_ = {7410};
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, BoundsParticipantsPerSocketAndPort) {
  int accepted = 0;
  for (int i = 1; i <= 100; ++i) accepted += accepts(announcement(i), {kLoopback, 5000}) ? 1 : 0;
  EXPECT_EQ(accepted, 4);
  EXPECT_FALSE(accepts(announcement(200), {kLoopback, 5001})) << "there are four at its port";
  open_.erase({kLoopback, 5000});
  EXPECT_TRUE(accepts(announcement(200), {kLoopback, 5001})) << "the sockets of the four are closed";
}

TEST_F(RtpsFilterTest, CountsPortsOfOtherMachinesSeparately) {
  const auto isHeard = [&](int i) {
    const std::uint32_t machine = kOtherMachine + static_cast<std::uint32_t>(i);
    return accepts(announcement(i, machine), {machine, 5000}, kNetwork);
  };
  for (int i = 1; i <= 10; ++i) ASSERT_TRUE(isHeard(i));
  EXPECT_TRUE(accepts(announcement(100), {kLoopback, 5000}))
      << "at a port that participants on other machines have, too";
  for (int i = 1; i <= 10; ++i) {
    EXPECT_TRUE(accepts(endpoint(i, i), {kOtherMachine + static_cast<std::uint32_t>(i), 5000}, kNetwork))
        << "still known";
  }
}

TEST_F(RtpsFilterTest, BoundsParticipantsPerAddressOfAnotherMachine) {
  ASSERT_TRUE(accepts(announcement(1, kOtherMachine), {kOtherMachine, 5000}, kNetwork));
  int accepted = 0;
  for (int i = 2; i < 2000; ++i) {
    const auto port = static_cast<std::uint32_t>(5000 + i);
    accepted += accepts(announcement(i, kOtherMachine + 1), {kOtherMachine + 1, port}, kNetwork) ? 1 : 0;
  }
  EXPECT_EQ(accepted, 128);
  EXPECT_TRUE(accepts(endpoint(1, 1), {kOtherMachine, 5000}, kNetwork));
}

TEST_F(RtpsFilterTest, AcceptsAnotherSocketOfAParticipantAfterItsLease) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  now_ += std::chrono::seconds(20);
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5001}));
  now_ += std::chrono::seconds(2);
  ASSERT_EQ(filter_.expireLeases(now_).messages.size(), 1);
  filter_.removed(prefixOf(1));
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5001}));
}

TEST_F(RtpsFilterTest, ForgetsAParticipantThatAnnouncesItsEnd) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_FALSE(accepts(goodbye(1), {kLoopback, 5001}));
  EXPECT_TRUE(accepts(goodbye(1), {kLoopback, 5000}));
  EXPECT_TRUE(before_.empty()) << "no discovery data has been sent";
  filter_.removed(prefixOf(1));
  EXPECT_FALSE(accepts(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, AcknowledgesAllDiscoveryDataInTheNameOfALeavingParticipant) {
  RtpsMessage sent;
  sent.discovery.emplace_back().writer = shared::kPublicationsWriter;
  sent.discovery.back().sequence = 7;
  sent.heartbeats = {{shared::kPublicationsWriter, 6}, {shared::kSubscriptionsWriter, 3}};
  filter_.recordSent(sent);
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
  ASSERT_TRUE(accepts(acknowledgement(1, 5, 4), {kLoopback, 5000}));
  EXPECT_TRUE(before_.empty());

  ASSERT_TRUE(accepts(goodbye(1), {kLoopback, 5000}));
  const auto last = shared::readRtpsMessage(before_);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->source, prefixOf(1));
  EXPECT_EQ(last->acknowledgements, (std::vector<RtpsAcknowledgement>{{shared::kPublicationsWriter, 8, 5},
                                                                      {shared::kSubscriptionsWriter, 4, 1}}));

  now_ += std::chrono::seconds(21);
  filter_.removed(prefixOf(1));
  const auto messages = filter_.expireLeases(now_).messages;
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(
      shared::readRtpsMessage(messages[0])->acknowledgements,
      (std::vector<RtpsAcknowledgement>{{shared::kPublicationsWriter, 8, 1}, {shared::kSubscriptionsWriter, 4, 1}}));
  EXPECT_EQ(shared::readRtpsMessage(messages[1])->discovery.size(), 1U);
}

TEST_F(RtpsFilterTest, BoundsQueriesOfTheSystemsSockets) {
  discovery_.clear();
  for (int i = 0; i < 10'000; ++i) accepts(announcement(i), {kLoopback, 5000});
  EXPECT_EQ(queries_, 300);
  now_ += std::chrono::seconds(1);
  discovery_ = {7410};
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, PassesAnAnnouncementOnUntilDdsHasDiscoveredItsParticipant) {
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000})) << "DDS may have lost it";
  filter_.discovered(prefixOf(1), now_);
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000}));
  now_ += std::chrono::seconds(10);
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000})) << "after ten seconds again";
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, RenewsTheLeaseByAnAnnouncementThatItDoesNotPassOn) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  filter_.discovered(prefixOf(1), now_);
  for (int i = 0; i < 9; ++i) {
    now_ += std::chrono::seconds(1);
    EXPECT_FALSE(accepts(announcement(1, kLoopback, 2), {kLoopback, 5000}));
    EXPECT_TRUE(filter_.expireLeases(now_).messages.empty());
  }
  now_ += std::chrono::seconds(3);
  EXPECT_EQ(filter_.expireLeases(now_).messages.size(), 1) << "its lease runs from the last one";
}

TEST_F(RtpsFilterTest, TellsWhetherAllAtAPortHaveAcknowledgedAHeartbeat) {
  const RtpsHeartbeat five{shared::kPublicationsWriter, 5};
  EXPECT_FALSE(filter_.isAcknowledged(7410, five)) << "no participant has this port";
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_FALSE(filter_.isAcknowledged(7410, five));
  ASSERT_TRUE(accepts(acknowledgement(1, 5, 1), {kLoopback, 5000}));
  EXPECT_FALSE(filter_.isAcknowledged(7410, five)) << "all below 5";
  ASSERT_TRUE(accepts(acknowledgement(1, 6, 3), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(acknowledgement(1, 2, 2), {kLoopback, 5000})) << "an older one that arrives late";
  EXPECT_TRUE(filter_.isAcknowledged(7410, five));
  EXPECT_FALSE(filter_.isAcknowledged(7410, {shared::kSubscriptionsWriter, 5}));
  EXPECT_FALSE(filter_.isAcknowledged(7412, five));
  ASSERT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
  EXPECT_FALSE(filter_.isAcknowledged(7410, five)) << "another one at this port has not";
}

TEST_F(RtpsFilterTest, AcceptsAnEmptyAcknowledgementAsARequestForAllData) {
  const RtpsHeartbeat five{shared::kPublicationsWriter, 5};
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(acknowledgement(1, 6, 1), {kLoopback, 5000}));
  EXPECT_TRUE(filter_.isAcknowledged(7410, five));
  ASSERT_TRUE(accepts(acknowledgement(1, 0, 2), {kLoopback, 5000}));
  EXPECT_FALSE(filter_.isAcknowledged(7410, five)) << "it requests all data again";
  EXPECT_TRUE(accepts(acknowledgement(1, 1, 3), {kLoopback, 5000}));
  EXPECT_TRUE(filter_.expireLeases(now_).messages.empty());
}

TEST_F(RtpsFilterTest, EndsTheLeaseOfAParticipantThatAcknowledgesLessThanBefore) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  filter_.discovered(prefixOf(1), now_);
  ASSERT_TRUE(accepts(acknowledgement(1, 6, 1), {kLoopback, 5000}));
  EXPECT_FALSE(accepts(acknowledgement(1, 1, 2), {kLoopback, 5000}));
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000})) << "until DDS has removed it";
  EXPECT_EQ(filter_.expireLeases(now_).messages.size(), 1U);
  filter_.removed(prefixOf(1));
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(accepts(acknowledgement(1, 1, 3), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, DropsMessagesOfTheSameProcess) {
  filter_.ignore(prefixOf(1), 7410);
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(filter_.isAcknowledged(7410, {shared::kPublicationsWriter, 5})) << "no heartbeat is needed there";
  EXPECT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
}

TEST_F(RtpsFilterTest, DropsMessagesOfASimulationsNodeInRos) {
  EXPECT_FALSE(accepts(announcement(1, kLoopback, 20, "enclave=/;pongsim=ros2;"), {kLoopback, 5000}));
  EXPECT_TRUE(accepts(announcement(2, kLoopback, 20, "enclave=/;"), {kLoopback, 5001})) << "a node of its own";
}

TEST_F(RtpsFilterTest, BoundsEndpointsPerSecond) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) accepted += accepts(endpoint(1, 1), {kLoopback, 5000}) ? 1 : 0;
  EXPECT_EQ(accepted, 5000);
  EXPECT_TRUE(accepts(endpoint(2, 2), {kLoopback, 5001})) << "each has its own limit";
  now_ += std::chrono::seconds(1);
  EXPECT_TRUE(accepts(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, MakesDdsRemoveASilentParticipant) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(accepts(announcement(2), {kLoopback, 5001}));
  now_ += std::chrono::seconds(19);
  ASSERT_TRUE(accepts(endpoint(2, 2), {kLoopback, 5001}));
  now_ += std::chrono::seconds(2);
  const RtpsFilter::Expiry expiry = filter_.expireLeases(now_);
  ASSERT_EQ(expiry.messages.size(), 1);
  EXPECT_EQ(shared::readRtpsMessage(expiry.messages[0])->source, prefixOf(1));
  EXPECT_EQ(expiry.nextCheck, now_ + std::chrono::seconds(1));
  EXPECT_FALSE(accepts(announcement(1), {kLoopback, 5000})) << "until DDS has removed it";
  filter_.removed(prefixOf(1));
  EXPECT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(accepts(endpoint(2, 2), {kLoopback, 5001}));
}

TEST_F(RtpsFilterTest, MakesDdsRemoveParticipantsWhosePlaceIsNeeded) {
  for (int i = 1; i <= 4; ++i) ASSERT_TRUE(accepts(announcement(i), {kLoopback, 5000}));
  open_.erase({kLoopback, 5000});
  ASSERT_TRUE(accepts(announcement(5), {kLoopback, 5001}));
  EXPECT_EQ(filter_.expireLeases(now_).messages.size(), 4);
}

TEST_F(RtpsFilterTest, EndsTheLeaseOfAParticipantThatOnlyDdsHasDiscovered) {
  filter_.discovered(prefixOf(1), now_);
  now_ += std::chrono::seconds(101);
  EXPECT_EQ(filter_.expireLeases(now_).messages.size(), 1);
}

TEST_F(RtpsFilterTest, DropsFragmentsOfSamplesLargerThanTheLargestMessage) {
  ASSERT_TRUE(accepts(announcement(1), {kLoopback, 5000}));
  const auto acceptsFragment = [&](std::uint32_t whole) {
    Packet packet(prefixOf(1));
    packet.begin(Kind::kDataFrag);
    packet.add16(0);
    packet.add16(28);
    packet.addEntity(0);
    packet.addEntity(0x103);
    packet.addSequence(1);
    packet.add32(1);
    packet.add16(1);
    packet.add16(64);
    packet.add32(whole);
    packet.addZeros(64);
    packet.end();
    return accepts(packet, {kLoopback, 5000});
  };
  EXPECT_TRUE(acceptsFragment(1000));
  EXPECT_FALSE(acceptsFragment(0xffffffff));
}

TEST_F(RtpsFilterTest, DropsAnnouncementsWithoutALease) {
  Packet packet(prefixOf(1));
  beginData(packet, shared::kSpdpWriter);
  packet.addGuid(0x50, prefixOf(1), 0x1c1);
  packet.addLocator(0x32, kLoopback, 7410);
  packet.addSentinel();
  packet.end();
  EXPECT_FALSE(accepts(packet, {kLoopback, 5000}));
}

TEST_F(RtpsFilterTest, AcceptsASocketForEachAddressOfAParticipant) {
  EXPECT_FALSE(accepts(announcement(1, kOtherMachine), {kOtherMachine + 1, 5000}, kNetwork))
      << "from an address that is not its own";
  EXPECT_TRUE(accepts(announcement(1, kOtherMachine), {kOtherMachine, 5000}, kNetwork));
  EXPECT_TRUE(accepts(endpoint(1, 1), {kLoopback, 5000})) << "from loopback";
  EXPECT_FALSE(accepts(endpoint(1, 1), {kLoopback, 5001}));
  EXPECT_FALSE(accepts(endpoint(1, 1), {kOtherMachine, 5001}, kNetwork));
  EXPECT_FALSE(accepts(endpoint(1, 1), {kOtherMachine + 1, 5000}, kNetwork));
}

}  // namespace

}  // namespace pongsim::transport
