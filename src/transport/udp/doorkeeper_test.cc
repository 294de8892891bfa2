#include "transport/udp/doorkeeper.hh"

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

constexpr std::uint32_t kLoopback = 0x7f000001, kBeyond = 0x0a070701;

RtpsPrefix prefixOf(int number) {
  return {1, 15, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8), 0, 0, 0, 0, 0, 0, 0, 0};
}

/// A doorkeeper on a machine with some open sockets; the test sets the time.
class DoorkeeperTest : public testing::Test {
 protected:
  bool admits(const Packet& packet, const RtpsAddress& from, Doorkeeper::Side side = Doorkeeper::Side::kLoopback) {
    bytes_.assign(packet.bytes().begin(), packet.bytes().end());
    Doorkeeper::Admission admission = doorkeeper_.admits(bytes_, from, side, now_);
    before_ = std::move(admission.before);
    return admission.isAdmitted;
  }

  static void beginData(Packet& packet, RtpsEntity writer) {
    packet.beginData(0, writer, 1, hostile::kWithData);
    packet.add32(0x00000300);
  }

  static Packet announcement(int number, std::uint32_t address = kLoopback, std::uint32_t lease = 20) {
    Packet packet(prefixOf(number));
    beginData(packet, shared::kSpdpWriter);
    packet.beginParameter(0x02);
    packet.add32(lease);
    packet.add32(0);
    packet.endParameter();
    packet.addGuid(0x50, prefixOf(number), 0x1c1);
    packet.addLocator(0x32, address, 7410);
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
  int looks_ = 0;
  Doorkeeper::TimePoint now_{};
  std::vector<std::uint8_t> bytes_;
  /// The message to pass to Fast DDS before the last one.
  std::vector<std::uint8_t> before_;
  Doorkeeper doorkeeper_{{[this](std::uint32_t port) {
                            ++looks_;
                            return discovery_.contains(port);
                          },
                          [this](const RtpsAddress& address) { return open_.contains(address); }}};
};

TEST_F(DoorkeeperTest, LetsInWhoAnnouncesItself) {
  EXPECT_FALSE(admits(endpoint(1, 1), {kLoopback, 5000})) << "before it has";
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(admits(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsNobodySpeakForAnother) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(admits(announcement(2), {kLoopback, 5001}));
  EXPECT_FALSE(admits(endpoint(1, 1), {kLoopback, 5001}));
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5001}));
  EXPECT_FALSE(admits(endpoint(1, 2), {kLoopback, 5000})) << "an endpoint of another's";
}

TEST_F(DoorkeeperTest, LetsInNobodyWhoIsNotThere) {
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 6000})) << "its socket has gone";
  discovery_.clear();
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000})) << "nobody listens where it says to";
  discovery_ = {7410};
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsInAFewOfASocketOrAPortAndThoseWhoComeAfterThem) {
  int admitted = 0;
  for (int i = 1; i <= 100; ++i) admitted += admits(announcement(i), {kLoopback, 5000}) ? 1 : 0;
  EXPECT_EQ(admitted, 4);
  EXPECT_FALSE(admits(announcement(200), {kLoopback, 5001})) << "others are at its port";
  open_.erase({kLoopback, 5000});
  EXPECT_TRUE(admits(announcement(200), {kLoopback, 5001})) << "who were killed";
}

TEST_F(DoorkeeperTest, TellsPortsOfOtherMachinesFromThoseOfThisOne) {
  constexpr auto kNetwork = Doorkeeper::Side::kBeyond;
  const auto isHeard = [&](int i) {
    const std::uint32_t machine = kBeyond + static_cast<std::uint32_t>(i);
    return admits(announcement(i, machine), {machine, 5000}, kNetwork);
  };
  for (int i = 1; i <= 10; ++i) ASSERT_TRUE(isHeard(i));
  EXPECT_TRUE(admits(announcement(100), {kLoopback, 5000})) << "at the port that all others have, too";
  for (int i = 1; i <= 10; ++i) {
    EXPECT_TRUE(admits(endpoint(i, i), {kBeyond + static_cast<std::uint32_t>(i), 5000}, kNetwork)) << "still known";
  }
}

TEST_F(DoorkeeperTest, KeepsThoseInMindWhoLiveWhereAnotherMachineTellsOfMany) {
  constexpr auto kNetwork = Doorkeeper::Side::kBeyond;
  ASSERT_TRUE(admits(announcement(1, kBeyond), {kBeyond, 5000}, kNetwork));
  int admitted = 0;
  for (int i = 2; i < 2000; ++i) {
    const auto port = static_cast<std::uint32_t>(5000 + i);
    admitted += admits(announcement(i, kBeyond + 1), {kBeyond + 1, port}, kNetwork) ? 1 : 0;
  }
  EXPECT_EQ(admitted, 128);
  EXPECT_TRUE(admits(endpoint(1, 1), {kBeyond, 5000}, kNetwork));
}

TEST_F(DoorkeeperTest, LetsInWhoHasAnotherSocketAfterItsLease) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  now_ += std::chrono::seconds(20);
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5001}));
  now_ += std::chrono::seconds(2);
  ASSERT_EQ(doorkeeper_.endings(now_).messages.size(), 1);
  doorkeeper_.removed(prefixOf(1));
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5001}));
}

TEST_F(DoorkeeperTest, ForgetsWhoSaysThatItHasGone) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_FALSE(admits(goodbye(1), {kLoopback, 5001}));
  EXPECT_TRUE(admits(goodbye(1), {kLoopback, 5000}));
  EXPECT_TRUE(before_.empty()) << "there is nothing that it could miss";
  doorkeeper_.removed(prefixOf(1));
  EXPECT_FALSE(admits(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsThoseAcknowledgeAllWhoLeave) {
  RtpsMessage sent;
  sent.discovery.emplace_back().writer = shared::kPublicationsWriter;
  sent.discovery.back().sequence = 7;
  sent.heartbeats = {{shared::kPublicationsWriter, 6}, {shared::kSubscriptionsWriter, 3}};
  doorkeeper_.sends(sent);
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(admits(announcement(2), {kLoopback, 5001}));
  ASSERT_TRUE(admits(acknowledgement(1, 5, 4), {kLoopback, 5000}));
  EXPECT_TRUE(before_.empty());

  ASSERT_TRUE(admits(goodbye(1), {kLoopback, 5000}));
  const auto last = shared::readRtpsMessage(before_);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->source, prefixOf(1));
  EXPECT_EQ(last->acknowledgements, (std::vector<RtpsAcknowledgement>{{shared::kPublicationsWriter, 8, 5},
                                                                      {shared::kSubscriptionsWriter, 4, 1}}));

  now_ += std::chrono::seconds(21);
  doorkeeper_.removed(prefixOf(1));
  const auto messages = doorkeeper_.endings(now_).messages;
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(
      shared::readRtpsMessage(messages[0])->acknowledgements,
      (std::vector<RtpsAcknowledgement>{{shared::kPublicationsWriter, 8, 1}, {shared::kSubscriptionsWriter, 4, 1}}));
  EXPECT_EQ(shared::readRtpsMessage(messages[1])->discovery.size(), 1U);
}

TEST_F(DoorkeeperTest, AsksTheSystemSoOftenOnly) {
  discovery_.clear();
  for (int i = 0; i < 10'000; ++i) admits(announcement(i), {kLoopback, 5000});
  EXPECT_EQ(looks_, 300);
  now_ += std::chrono::seconds(1);
  discovery_ = {7410};
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, PassesOnAnAnnouncementUntilItIsKnown) {
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000})) << "the library may have missed it";
  doorkeeper_.discovered(prefixOf(1), now_);
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000}));
  now_ += std::chrono::seconds(10);
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000})) << "once in a while it sees it again";
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, HearsAnAnnouncementThatItDoesNotPassOn) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  doorkeeper_.discovered(prefixOf(1), now_);
  for (int i = 0; i < 9; ++i) {
    now_ += std::chrono::seconds(1);
    EXPECT_FALSE(admits(announcement(1, kLoopback, 2), {kLoopback, 5000}));
    EXPECT_TRUE(doorkeeper_.endings(now_).messages.empty());
  }
  now_ += std::chrono::seconds(3);
  EXPECT_EQ(doorkeeper_.endings(now_).messages.size(), 1) << "its lease runs from the last one";
}

TEST_F(DoorkeeperTest, KnowsWhatHasBeenAcknowledged) {
  const RtpsHeartbeat five{shared::kPublicationsWriter, 5};
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, five)) << "nobody is there";
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, five));
  ASSERT_TRUE(admits(acknowledgement(1, 5, 1), {kLoopback, 5000}));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, five)) << "all below 5";
  ASSERT_TRUE(admits(acknowledgement(1, 6, 3), {kLoopback, 5000}));
  ASSERT_TRUE(admits(acknowledgement(1, 2, 2), {kLoopback, 5000})) << "is late";
  EXPECT_TRUE(doorkeeper_.isAcknowledged(7410, five));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, {shared::kSubscriptionsWriter, 5}));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7412, five));
  ASSERT_TRUE(admits(announcement(2), {kLoopback, 5001}));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, five)) << "another one at this port has not";
}

TEST_F(DoorkeeperTest, AnswersWhoHasForgottenTheParticipantAndAsksForAll) {
  const RtpsHeartbeat five{shared::kPublicationsWriter, 5};
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(admits(acknowledgement(1, 6, 1), {kLoopback, 5000}));
  EXPECT_TRUE(doorkeeper_.isAcknowledged(7410, five));
  ASSERT_TRUE(admits(acknowledgement(1, 0, 2), {kLoopback, 5000}));
  EXPECT_FALSE(doorkeeper_.isAcknowledged(7410, five)) << "is to hear what there is";
  EXPECT_TRUE(admits(acknowledgement(1, 1, 3), {kLoopback, 5000}));
  EXPECT_TRUE(doorkeeper_.endings(now_).messages.empty());
}

TEST_F(DoorkeeperTest, DropsWhoHasForgottenTheParticipantAndMissesSome) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  doorkeeper_.discovered(prefixOf(1), now_);
  ASSERT_TRUE(admits(acknowledgement(1, 6, 1), {kLoopback, 5000}));
  EXPECT_FALSE(admits(acknowledgement(1, 1, 2), {kLoopback, 5000}));
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000})) << "the library has to drop it first";
  EXPECT_EQ(doorkeeper_.endings(now_).messages.size(), 1U);
  doorkeeper_.removed(prefixOf(1));
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(admits(acknowledgement(1, 1, 3), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsInNobodyOfTheSameProcess) {
  doorkeeper_.ignore(prefixOf(1), 7410);
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(doorkeeper_.isAcknowledged(7410, {shared::kPublicationsWriter, 5})) << "nothing has to be said there";
  EXPECT_TRUE(admits(announcement(2), {kLoopback, 5001}));
}

TEST_F(DoorkeeperTest, BoundsEndpointsByTime) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(admits(announcement(2), {kLoopback, 5001}));
  int admitted = 0;
  for (int i = 0; i < 20'000; ++i) admitted += admits(endpoint(1, 1), {kLoopback, 5000}) ? 1 : 0;
  EXPECT_EQ(admitted, 5000);
  EXPECT_TRUE(admits(endpoint(2, 2), {kLoopback, 5001})) << "others have their own";
  now_ += std::chrono::seconds(1);
  EXPECT_TRUE(admits(endpoint(1, 1), {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsTheLibraryDropWhoHasBeenSilent) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  ASSERT_TRUE(admits(announcement(2), {kLoopback, 5001}));
  now_ += std::chrono::seconds(19);
  ASSERT_TRUE(admits(endpoint(2, 2), {kLoopback, 5001}));
  now_ += std::chrono::seconds(2);
  const Doorkeeper::Endings endings = doorkeeper_.endings(now_);
  ASSERT_EQ(endings.messages.size(), 1);
  EXPECT_EQ(shared::readRtpsMessage(endings.messages[0])->source, prefixOf(1));
  EXPECT_EQ(endings.nextLook, now_ + std::chrono::seconds(1));
  EXPECT_FALSE(admits(announcement(1), {kLoopback, 5000})) << "it has not been dropped yet";
  doorkeeper_.removed(prefixOf(1));
  EXPECT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  EXPECT_TRUE(admits(endpoint(2, 2), {kLoopback, 5001}));
}

TEST_F(DoorkeeperTest, LetsTheLibraryDropThoseWhomItForgets) {
  for (int i = 1; i <= 4; ++i) ASSERT_TRUE(admits(announcement(i), {kLoopback, 5000}));
  open_.erase({kLoopback, 5000});
  ASSERT_TRUE(admits(announcement(5), {kLoopback, 5001}));
  EXPECT_EQ(doorkeeper_.endings(now_).messages.size(), 4);
}

TEST_F(DoorkeeperTest, EndsTheLeaseOfWhomTheLibraryAloneKnows) {
  doorkeeper_.discovered(prefixOf(1), now_);
  now_ += std::chrono::seconds(101);
  EXPECT_EQ(doorkeeper_.endings(now_).messages.size(), 1);
}

TEST_F(DoorkeeperTest, LetsInNoFragmentOfMoreThanAMessageMayBe) {
  ASSERT_TRUE(admits(announcement(1), {kLoopback, 5000}));
  const auto admitsFragment = [&](std::uint32_t whole) {
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
    return admits(packet, {kLoopback, 5000});
  };
  EXPECT_TRUE(admitsFragment(1000));
  EXPECT_FALSE(admitsFragment(0xffffffff));
}

TEST_F(DoorkeeperTest, LetsInNobodyWithoutALease) {
  Packet packet(prefixOf(1));
  beginData(packet, shared::kSpdpWriter);
  packet.addGuid(0x50, prefixOf(1), 0x1c1);
  packet.addLocator(0x32, kLoopback, 7410);
  packet.addSentinel();
  packet.end();
  EXPECT_FALSE(admits(packet, {kLoopback, 5000}));
}

TEST_F(DoorkeeperTest, LetsInWhoHasASocketForEachOfItsAddresses) {
  constexpr auto kNetwork = Doorkeeper::Side::kBeyond;
  EXPECT_FALSE(admits(announcement(1, kBeyond), {kBeyond + 1, 5000}, kNetwork)) << "from where it is not";
  EXPECT_TRUE(admits(announcement(1, kBeyond), {kBeyond, 5000}, kNetwork));
  EXPECT_TRUE(admits(endpoint(1, 1), {kLoopback, 5000})) << "the same, on this machine";
  EXPECT_FALSE(admits(endpoint(1, 1), {kLoopback, 5001}));
  EXPECT_FALSE(admits(endpoint(1, 1), {kBeyond, 5001}, kNetwork));
  EXPECT_FALSE(admits(endpoint(1, 1), {kBeyond + 1, 5000}, kNetwork));
}

}  // namespace

}  // namespace pongsim::transport
