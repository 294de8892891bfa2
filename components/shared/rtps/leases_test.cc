#include "shared/rtps/leases.hh"

#include <gtest/gtest.h>

#include <optional>

#include "hostile/packet.hh"

namespace pongsim::shared {

namespace {

using hostile::Packet;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr RtpsPrefix kNeighbour = {1, 15, 7}, kOther = {1, 15, 8};

/// Leases of 1 to 100 s, whose clock is told.
class LeasesTest : public testing::Test {
 protected:
  /// @param lease In seconds, and 2^-32 of a second.
  bool hearAnnouncement(const RtpsPrefix& prefix, std::uint32_t lease, std::uint32_t fraction = 0,
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
    return hear(packet);
  }

  bool hearGoodbye(const RtpsPrefix& prefix) { return hear(hostile::goodbye(prefix)); }

  /// Something that is no announcement.
  bool hearWord(const RtpsPrefix& prefix) { return hear(Packet(prefix)); }

  std::optional<Leases::Ending> ending() {
    const auto endings = leases_.endings(now_);
    return endings.size() == 1 ? std::optional(endings.front()) : std::nullopt;
  }

  std::vector<std::uint8_t> heard_;
  Leases::TimePoint now_ = Leases::TimePoint(std::chrono::hours(1));
  Leases leases_{{seconds(1), seconds(100), seconds(10)}};

 private:
  bool hear(const Packet& packet) {
    heard_.assign(packet.bytes().begin(), packet.bytes().end());
    return leases_.hear(*readRtpsMessage(heard_), heard_, now_);
  }
};

TEST_F(LeasesTest, AreEndlessForTheLibrary) {
  for (const std::uint32_t told : {0U, 20U, 0x7fffffffU, 0xffffffffU}) {
    ASSERT_TRUE(hearAnnouncement(kNeighbour, told));
    const auto message = readRtpsMessage(heard_);
    ASSERT_TRUE(message);
    EXPECT_EQ(message->discovery.at(0).lease, seconds(1 << 30));
  }
}

TEST_F(LeasesTest, EndWhenNothingHasBeenHeardForSoLong) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 5, 1U << 31));
  now_ += seconds(5);
  EXPECT_TRUE(hearWord(kNeighbour));
  now_ += milliseconds(5500);
  EXPECT_FALSE(ending());
  EXPECT_TRUE(leases_.runs(kNeighbour));
  now_ += milliseconds(1);
  const auto told = ending();
  ASSERT_TRUE(told);
  EXPECT_EQ(told->prefix, kNeighbour);
  EXPECT_TRUE(leases_.hasEnded(kNeighbour));
}

TEST_F(LeasesTest, AreWithinBounds) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 0));
  ASSERT_TRUE(hearAnnouncement(kOther, 0xffffffff));
  now_ += milliseconds(999);
  EXPECT_TRUE(leases_.endings(now_).empty());
  now_ += milliseconds(2);
  EXPECT_EQ(ending()->prefix, kNeighbour);
  leases_.removed(kNeighbour);
  now_ += seconds(98);
  EXPECT_FALSE(ending());
  now_ += seconds(2);
  EXPECT_EQ(ending()->prefix, kOther);
}

TEST_F(LeasesTest, AreToldToHaveEndedUntilTheLibraryKnows) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1, 0, 40));
  now_ += seconds(2);
  EXPECT_EQ(ending()->sequence, 41);
  EXPECT_FALSE(ending()) << "at once again";
  now_ += seconds(1);
  EXPECT_EQ(ending()->sequence, 42) << "newer than what has been seen";
  leases_.removed(kNeighbour);
  now_ += seconds(1);
  EXPECT_FALSE(ending());
}

TEST_F(LeasesTest, AreToldSomeTimesWhereTheLibraryNeverKnew) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1));
  int times = 0;
  for (int i = 0; i < 20; ++i) {
    now_ += seconds(2);
    times += ending() ? 1 : 0;
  }
  EXPECT_EQ(times, 5);
  EXPECT_EQ(leases_.size(), 0);
}

TEST_F(LeasesTest, LetNothingByThatComesTooLate) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1));
  now_ += seconds(2);
  EXPECT_FALSE(hearWord(kNeighbour)) << "before its end is told";
  EXPECT_TRUE(ending());
}

TEST_F(LeasesTest, LetNothingByThatCouldMeetTheEnd) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1));
  now_ += seconds(2);
  ASSERT_TRUE(ending());
  EXPECT_FALSE(hearGoodbye(kNeighbour));
  EXPECT_FALSE(hearAnnouncement(kNeighbour, 1));
  leases_.removed(kNeighbour);
  EXPECT_TRUE(hearAnnouncement(kNeighbour, 1)) << "it was stopped, and is back";
  EXPECT_TRUE(leases_.runs(kNeighbour));
}

TEST_F(LeasesTest, DoNotEndWhileAGoodbyeIsOnItsWay) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1));
  EXPECT_TRUE(hearGoodbye(kNeighbour));
  now_ += seconds(9);
  EXPECT_FALSE(ending());
  now_ += seconds(2);
  EXPECT_TRUE(ending()) << "the library does not heed it";
}

TEST_F(LeasesTest, AreThereForWhomTheLibraryKnows) {
  leases_.discovered(kNeighbour, now_);
  now_ += seconds(99);
  EXPECT_FALSE(ending());
  now_ += seconds(2);
  EXPECT_TRUE(ending());
}

TEST_F(LeasesTest, CanBeEnded) {
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 100));
  leases_.end(kNeighbour);
  leases_.end(kOther);
  EXPECT_FALSE(leases_.runs(kNeighbour));
  EXPECT_EQ(ending()->prefix, kNeighbour);
}

TEST_F(LeasesTest, AreLookedAtWhenOneMayEndAndEverySecond) {
  EXPECT_EQ(leases_.nextLook(now_), now_ + seconds(1));
  ASSERT_TRUE(hearAnnouncement(kNeighbour, 1, 1U << 30));
  now_ += seconds(1);
  const auto next = leases_.nextLook(now_);
  EXPECT_EQ(next, now_ + milliseconds(250) + std::chrono::nanoseconds(1));
  now_ = next;
  EXPECT_TRUE(ending());
}

}  // namespace

}  // namespace pongsim::shared
