#include "shared/rtps/leases.hh"

#include <gtest/gtest.h>

#include <optional>

#include "hostile/packet.hh"

namespace pongsim::shared {

namespace {

using hostile::Packet;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr RtpsPrefix kParticipant = {1, 15, 7}, kOther = {1, 15, 8};

/// Leases of 1 to 100 s, whose clock is told.
class LeasesTest : public testing::Test {
 protected:
  /// @param lease In seconds, and 2^-32 of a second.
  bool receiveAnnouncement(const RtpsPrefix& prefix, std::uint32_t lease, std::uint32_t fraction = 0,
                           std::int64_t sequence = 1) {
    Packet packet(prefix);
    packet.beginData(0, kSpdpWriter, sequence, hostile::kWithData);
    packet.add32(0x00000300);
    packet.addGuid(0x50, prefix, 0x1c1);
    packet.beginParameter(0x02);
    packet.add32(lease);
    packet.add32(fraction);
    packet.endParameter();
    packet.addSentinel();
    packet.end();
    return receive(packet);
  }

  bool receiveGoodbye(const RtpsPrefix& prefix) { return receive(hostile::goodbye(prefix)); }

  /// A message without submessages.
  bool receiveEmpty(const RtpsPrefix& prefix) { return receive(Packet(prefix)); }

  std::optional<Leases::Expired> expired() {
    const auto all = leases_.expired(now_);
    return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
  }

  std::vector<std::uint8_t> received_;
  Leases::TimePoint now_ = Leases::TimePoint(std::chrono::hours(1));
  Leases leases_{{seconds(1), seconds(100), seconds(10)}};

 private:
  bool receive(const Packet& packet) {
    received_.assign(packet.bytes().begin(), packet.bytes().end());
    return leases_.receive(*readRtpsMessage(received_), received_, now_);
  }
};

TEST_F(LeasesTest, AreInfiniteInWhatIsPassedOn) {
  for (const std::uint32_t announced : {0U, 20U, 0x7fffffffU, 0xffffffffU}) {
    ASSERT_TRUE(receiveAnnouncement(kParticipant, announced));
    const auto message = readRtpsMessage(received_);
    ASSERT_TRUE(message);
    EXPECT_EQ(message->discovery.at(0).lease, seconds(1 << 30));
  }
}

TEST_F(LeasesTest, EndAfterTheirDurationWithoutAMessage) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 5, 1U << 31));
  now_ += seconds(5);
  EXPECT_TRUE(receiveEmpty(kParticipant));
  now_ += milliseconds(5500);
  EXPECT_FALSE(expired());
  EXPECT_TRUE(leases_.runs(kParticipant));
  now_ += milliseconds(1);
  const auto end = expired();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->prefix, kParticipant);
  EXPECT_TRUE(leases_.hasEnded(kParticipant));
}

TEST_F(LeasesTest, AreClampedToBounds) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 0));
  ASSERT_TRUE(receiveAnnouncement(kOther, 0xffffffff));
  now_ += milliseconds(999);
  EXPECT_TRUE(leases_.expired(now_).empty());
  now_ += milliseconds(2);
  EXPECT_EQ(expired()->prefix, kParticipant);
  leases_.removed(kParticipant);
  now_ += seconds(98);
  EXPECT_FALSE(expired());
  now_ += seconds(2);
  EXPECT_EQ(expired()->prefix, kOther);
}

TEST_F(LeasesTest, AreReportedEachSecondUntilTheParticipantIsRemoved) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1, 0, 40));
  now_ += seconds(2);
  EXPECT_EQ(expired()->sequence, 41);
  EXPECT_FALSE(expired()) << "not again at once";
  now_ += seconds(1);
  EXPECT_EQ(expired()->sequence, 42) << "higher than before";
  leases_.removed(kParticipant);
  now_ += seconds(1);
  EXPECT_FALSE(expired());
}

TEST_F(LeasesTest, AreReportedFiveTimesIfTheParticipantIsNeverRemoved) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1));
  int times = 0;
  for (int i = 0; i < 20; ++i) {
    now_ += seconds(2);
    times += expired() ? 1 : 0;
  }
  EXPECT_EQ(times, 5);
  EXPECT_EQ(leases_.size(), 0);
}

TEST_F(LeasesTest, StopMessagesThatArriveAfterTheEnd) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1));
  now_ += seconds(2);
  EXPECT_FALSE(receiveEmpty(kParticipant)) << "before its end is reported";
  EXPECT_TRUE(expired());
}

TEST_F(LeasesTest, StopMessagesUntilTheParticipantIsRemoved) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1));
  now_ += seconds(2);
  ASSERT_TRUE(expired());
  EXPECT_FALSE(receiveGoodbye(kParticipant));
  EXPECT_FALSE(receiveAnnouncement(kParticipant, 1));
  leases_.removed(kParticipant);
  EXPECT_TRUE(receiveAnnouncement(kParticipant, 1)) << "it was stopped, and has continued";
  EXPECT_TRUE(leases_.runs(kParticipant));
}

TEST_F(LeasesTest, LeaveTimeToRemoveAParticipantThatHasAnnouncedItsEnd) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1));
  EXPECT_TRUE(receiveGoodbye(kParticipant));
  now_ += seconds(9);
  EXPECT_FALSE(expired());
  now_ += seconds(2);
  EXPECT_TRUE(expired()) << "it has not been removed";
}

TEST_F(LeasesTest, AreTheLongestForAParticipantThatOnlyDdsHasDiscovered) {
  leases_.discovered(kParticipant, now_);
  now_ += seconds(99);
  EXPECT_FALSE(expired());
  now_ += seconds(2);
  EXPECT_TRUE(expired());
}

TEST_F(LeasesTest, CanBeEnded) {
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 100));
  leases_.end(kParticipant);
  leases_.end(kOther);
  EXPECT_FALSE(leases_.runs(kParticipant));
  EXPECT_EQ(expired()->prefix, kParticipant);
}

TEST_F(LeasesTest, AreCheckedWhenTheNextMayEndAndEverySecond) {
  EXPECT_EQ(leases_.nextCheck(now_), now_ + seconds(1));
  ASSERT_TRUE(receiveAnnouncement(kParticipant, 1, 1U << 30));
  now_ += seconds(1);
  const auto next = leases_.nextCheck(now_);
  EXPECT_EQ(next, now_ + milliseconds(250) + std::chrono::nanoseconds(1));
  now_ = next;
  EXPECT_TRUE(expired());
}

}  // namespace

}  // namespace pongsim::shared
