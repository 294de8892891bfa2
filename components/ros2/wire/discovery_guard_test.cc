#include "ros2/wire/discovery_guard.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

#include "support/rtps/announced.hh"

namespace pongsim::ros2 {
namespace {

using namespace test;
using shared::RtpsDiscovery;
using shared::RtpsMessage;
using shared::RtpsPrefix;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr RtpsPrefix kNeighbour = {1, 16, 7}, kAnotherNeighbour = {1, 16, 8};

class DiscoveryGuardTest : public testing::Test {
 protected:
  /// @return Whether Fast DDS got it.
  bool receive(std::vector<std::uint8_t> message) {
    bool isHandedOn = false;
    guard_.receive(message, now_, [&](auto) { isHandedOn = true; });
    return isHandedOn;
  }

  /// Lets time pass as it does where the ends of leases are asked for in time.
  /// @return Those that ended.
  std::vector<RtpsPrefix> pass(DiscoveryGuard::TimePoint::duration duration) {
    std::vector<RtpsPrefix> ended;
    const auto end = now_ + duration;
    while (true) {
      const auto next = guard_.end(now_, [&](std::span<const std::uint8_t> message) {
        RtpsPrefix& prefix = ended.emplace_back();
        std::copy_n(message.begin() + 8, prefix.size(), prefix.begin());
      });
      EXPECT_GT(next, now_);
      EXPECT_LE(next, now_ + seconds(1));
      if (next > end) break;
      now_ = next;
    }
    now_ = end;
    return ended;
  }

  DiscoveryGuard guard_;
  DiscoveryGuard::TimePoint now_ = DiscoveryGuard::TimePoint(std::chrono::hours(1));
};

TEST_F(DiscoveryGuardTest, EndAfterSilenceOnly) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  ASSERT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .lease = 10})));
  EXPECT_TRUE(pass(milliseconds(4500)).empty());
  // anything that it says counts
  ASSERT_TRUE(receive(bytesOf(hostile::Packet(kNeighbour))));
  EXPECT_TRUE(pass(milliseconds(4900)).empty());
  EXPECT_EQ(pass(milliseconds(200)), std::vector{kNeighbour});
  EXPECT_EQ(pass(seconds(5)), std::vector{kAnotherNeighbour});
  EXPECT_EQ(guard_.size(), 0);
  EXPECT_TRUE(pass(seconds(20)).empty());
}

TEST_F(DiscoveryGuardTest, OfAllWhoSpeakInAMessageGoOn) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  ASSERT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .lease = 5})));
  EXPECT_TRUE(pass(seconds(4)).empty());
  hostile::Packet both(kNeighbour);
  addSource(both, kAnotherNeighbour);
  addSource(both, kNeighbour);
  ASSERT_TRUE(receive(bytesOf(both)));
  EXPECT_TRUE(pass(seconds(4)).empty());
  EXPECT_EQ(pass(seconds(2)), (std::vector{kNeighbour, kAnotherNeighbour}));
}

TEST_F(DiscoveryGuardTest, KnowNoParticipantOfPongsimsOwnTopics) {
  EXPECT_FALSE(receive(announcementOf({.participant = kNeighbour, .name = "pongsim/4711"})));
  EXPECT_EQ(guard_.size(), 0);
  EXPECT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .name = "/"})));
}

TEST_F(DiscoveryGuardTest, RunOnForThoseWhoAnnounceThemForever) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 0x7fffffff})));
  EXPECT_TRUE(pass(std::chrono::hours(2)).empty());
  EXPECT_EQ(guard_.size(), 1);
}

TEST_F(DiscoveryGuardTest, EndSoonWithAGoodbye) {
  for (const Goodbye form : {Goodbye::kWithHash, Goodbye::kWithKey}) {
    ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 1000})));
    ASSERT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .lease = 1000})));
    ASSERT_TRUE(receive(goodbyeOf(kNeighbour, form))) << "Fast DDS may have understood it";
    EXPECT_EQ(pass(seconds(2)), std::vector{kNeighbour});
    EXPECT_EQ(guard_.size(), 1);
  }
  ASSERT_TRUE(receive(goodbyeOf(kNeighbour)));
  EXPECT_EQ(guard_.size(), 1) << "nobody is known by a goodbye";
}

TEST_F(DiscoveryGuardTest, EndBeforeWhoWasSilentIsHeardAgain) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  now_ += seconds(6);
  EXPECT_FALSE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  EXPECT_FALSE(receive(bytesOf(hostile::Packet(kNeighbour))));
  EXPECT_FALSE(receive(goodbyeOf(kNeighbour)));
  std::size_t ended = 0;
  guard_.end(now_, [&](auto) { ++ended; });
  EXPECT_EQ(ended, 1);
  EXPECT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  EXPECT_TRUE(receive(bytesOf(hostile::Packet(kNeighbour))));
}

TEST_F(DiscoveryGuardTest, LetEachGoodbyeBeNewerThanTheLast) {
  std::vector<std::uint8_t> last;
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 0})));
    now_ += milliseconds(100);
    std::vector<std::uint8_t> number;
    guard_.end(now_, [&](std::span<const std::uint8_t> message) {
      // of DATA: its upper half, then its lower half, least significant byte first
      const auto sequence = message.subspan(20 + 4 + 12, 8);
      for (const int at : {3, 2, 1, 0, 7, 6, 5, 4}) number.push_back(sequence[at]);
    });
    ASSERT_EQ(number.size(), 8);
    EXPECT_GT(number, last);
    last = number;
  }
}

TEST_F(DiscoveryGuardTest, LetFastDdsHandleOneAnnouncementAtATime) {
  constexpr int kTimes = 200;
  const DiscoveryGuard::TimePoint begin = now_;
  std::atomic<int> inside = 0, most = 0;
  const auto handOn = [&](auto) {
    most = std::max(most.load(), ++inside);
    std::this_thread::yield();
    --inside;
  };
  const auto announce = [&](const RtpsPrefix& prefix) {
    for (int i = 0; i < kTimes; ++i) {
      std::vector<std::uint8_t> message = announcementOf({.participant = prefix, .lease = 0});
      guard_.receive(message, begin, handOn);
    }
  };
  std::thread first([&] { announce(kNeighbour); }), second([&] { announce(kAnotherNeighbour); });
  for (int i = 0; i < kTimes; ++i) guard_.end(now_ += milliseconds(20), handOn);
  first.join();
  second.join();
  EXPECT_EQ(most, 1);
}

TEST_F(DiscoveryGuardTest, LetDataPassMeanwhile) {
  std::vector<std::uint8_t> announcement = announcementOf({.participant = kNeighbour});
  bool isHandedOn = false;
  guard_.receive(announcement, now_, [&](auto) {
    std::thread([&] { isHandedOn = receive(bytesOf(hostile::Packet(kNeighbour))); }).join();
  });
  EXPECT_TRUE(isHandedOn);
}

TEST_F(DiscoveryGuardTest, LetNothingPassThatCantBeRead) {
  EXPECT_FALSE(receive(announcementOf({.participant = kNeighbour, .lease = std::nullopt})));
  EXPECT_EQ(guard_.size(), 0);
}

/// @return What a guard hands on of it, as Fast DDS reads it.
std::optional<RtpsMessage> handedOn(std::vector<std::uint8_t> bytes) {
  std::optional<RtpsMessage> message;
  DiscoveryGuard().receive(bytes, {},
                           [&](std::span<const std::uint8_t> handed) { message = shared::readAnyRtpsMessage(handed); });
  return message;
}
std::optional<RtpsMessage> handedOn(const hostile::Packet& packet) { return handedOn(bytesOf(packet)); }

bool isRefused(const Announced& announced) { return !handedOn(announcementOf(announced)); }

constexpr seconds kEndless{1 << 30};

TEST(DiscoveryGuard, MakesLeasesEndlessInEitherByteOrder) {
  EXPECT_EQ(handedOn(announcementOf({.participant = kNeighbour, .lease = 5}))->discovery.at(0).lease, kEndless);
  constexpr std::uint8_t kBigDataFlags = 4;
  std::vector<std::uint8_t> bytes{'R', 'T', 'P', 'S', 2, 3, 1, 16};
  const auto add = [&](std::initializer_list<std::uint8_t> more) { bytes.insert(bytes.end(), more); };
  bytes.insert(bytes.end(), kNeighbour.begin(), kNeighbour.end());
  add({0x15, kBigDataFlags, 0, 0, 0, 0, 0, 16, 0, 1, 0, 0xc7, 0, 1, 0, 0xc2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 0});
  add({0, 0x50, 0, 16});
  bytes.insert(bytes.end(), kNeighbour.begin(), kNeighbour.end());
  add({0, 0, 1, 0xc1, 0, 0x58, 0, 4, 0, 0, 0, 0x3f, 0, 2, 0, 8, 0, 0, 0, 7, 0x80, 0, 0, 0, 0, 1, 0, 0});
  EXPECT_EQ(shared::readAnyRtpsMessage(bytes)->discovery.at(0).lease, milliseconds(7500));
  EXPECT_EQ(handedOn(bytes)->discovery.at(0).lease, kEndless);
}

TEST(DiscoveryGuard, KnowsSeveralParticipantsInOneMessage) {
  // as those of one process by Cyclone DDS are
  hostile::Packet packet(kNeighbour);
  addAnnouncement(packet, {.participant = kNeighbour, .lease = 10});
  addSource(packet, kAnotherNeighbour);
  addAnnouncement(packet, {.participant = kAnotherNeighbour, .lease = 11});
  const auto before = shared::readAnyRtpsMessage(packet.bytes());
  ASSERT_TRUE(before);
  EXPECT_EQ(before->source, kNeighbour);
  EXPECT_EQ(before->otherSources, std::vector{kAnotherNeighbour});
  ASSERT_EQ(before->discovery.size(), 2);
  EXPECT_EQ(before->discovery[0].participant(), kNeighbour);
  EXPECT_EQ(before->discovery[0].lease, seconds(10));
  EXPECT_EQ(before->discovery[1].participant(), kAnotherNeighbour);
  EXPECT_EQ(before->discovery[1].lease, seconds(11));
  const auto after = handedOn(packet);
  ASSERT_TRUE(after);
  for (const RtpsDiscovery& each : after->discovery) EXPECT_EQ(each.lease, kEndless);
}

TEST(DiscoveryGuard, LetsAnotherParticipantOfTheProcessAnnounceOne) {
  hostile::Packet packet(kNeighbour);
  addAnnouncement(packet, {.participant = kAnotherNeighbour});
  const auto message = handedOn(packet);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->discovery.at(0).participant(), kAnotherNeighbour);
}

TEST(DiscoveryGuard, KnowsGoodbyesInEitherForm) {
  for (const Goodbye form : {Goodbye::kWithHash, Goodbye::kWithKey}) {
    hostile::Packet packet(kNeighbour);
    addGoodbye(packet, kAnotherNeighbour, form);
    const auto message = handedOn(packet);
    ASSERT_TRUE(message);
    ASSERT_EQ(message->discovery.size(), 1);
    EXPECT_EQ(message->discovery[0].participant(), kAnotherNeighbour);
    EXPECT_TRUE(message->discovery[0].isGone);
  }
}

TEST(DiscoveryGuard, LetsNoLeaseByThatFastDdsAloneReads) {
  hostile::Packet twice(kNeighbour);
  beginAnnouncement(twice, 4, 1);
  twice.add32(0x00000300);
  twice.addGuid(kGuidId, kNeighbour, hostile::entity::kParticipant);
  twice.addNumberParameter(kEndpointsId, 0x3f);
  addLease(twice, 1);
  addLease(twice, 2);
  twice.addSentinel();
  twice.end();
  EXPECT_EQ(shared::readAnyRtpsMessage(twice.bytes())->discovery.at(0).lease, seconds(2)) << "Fast DDS takes the last";
  std::size_t endless = 0;
  std::vector<std::uint8_t> bytes = bytesOf(twice);
  DiscoveryGuard().receive(bytes, {}, [&](std::span<const std::uint8_t> handed) {
    for (std::size_t i = 0; i + 4 <= handed.size(); i += 4) {
      if (std::ranges::equal(handed.subspan(i, 4), std::vector<std::uint8_t>{0, 0, 0, 0x40})) ++endless;
    }
  });
  EXPECT_EQ(endless, 2);

  hostile::Packet fragment(kNeighbour);
  fragment.begin(hostile::Kind::kDataFrag);
  fragment.add16(0);
  fragment.add16(28);
  fragment.addEntity(0);
  fragment.addEntity(hostile::entity::kSpdpWriter);
  fragment.addSequence(1);
  fragment.addZeros(80);
  fragment.end();
  EXPECT_FALSE(handedOn(fragment));

  hostile::Packet endlessList(kNeighbour);
  beginAnnouncement(endlessList, 4, 1);
  endlessList.add32(0x00000300);
  endlessList.addGuid(kGuidId, kNeighbour, hostile::entity::kParticipant);
  endlessList.addNumberParameter(kEndpointsId, 0x3f);
  addLease(endlessList, 1);
  endlessList.end();
  addAnnouncement(endlessList, {.participant = kNeighbour});
  EXPECT_FALSE(handedOn(endlessList)) << "the list would go on in the next submessage";
}

TEST(DiscoveryGuard, RefusesAnnouncementsWhereAGoodbyeWouldNotDo) {
  EXPECT_FALSE(isRefused({.participant = kNeighbour}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .lease = std::nullopt}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .endpoints = std::nullopt}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .endpoints = 0x3e}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .entity = 0x000002c1}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .sequence = 0}));
  EXPECT_FALSE(isRefused({.participant = kNeighbour, .sequence = std::int64_t(1) << 48}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .sequence = (std::int64_t(1) << 48) + 1}));
  EXPECT_TRUE(isRefused({.participant = kNeighbour, .sequence = std::numeric_limits<std::int64_t>::max()}));
}

TEST(DiscoveryGuard, LeavesWhatElseIsInMessages) {
  // a fragment of 100 MB
  hostile::Packet fragment(kNeighbour);
  fragment.begin(hostile::Kind::kDataFrag);
  fragment.add16(0);
  fragment.add16(28);
  fragment.addEntity(0);
  fragment.addEntity(0x00001203);
  fragment.addSequence(1);
  fragment.add32(1'500);
  fragment.add16(1);
  fragment.add16(64'000);
  fragment.add32(100'000'000);
  fragment.addZeros(64);
  fragment.end();
  std::vector<std::uint8_t> bytes = bytesOf(fragment);
  bool isHandedOn = false;
  DiscoveryGuard().receive(bytes, {}, [&](std::span<const std::uint8_t> handed) {
    isHandedOn = std::ranges::equal(handed, fragment.bytes());
  });
  EXPECT_TRUE(isHandedOn);
  EXPECT_FALSE(handedOn(std::vector<std::uint8_t>{1, 2, 3})) << "which Fast DDS drops";
}

}  // namespace
}  // namespace pongsim::ros2
