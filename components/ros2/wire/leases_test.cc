#include "ros2/wire/leases.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "support/ros2/announced.hh"

namespace pongsim::ros2 {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr GuidPrefix kNeighbour = {1, 16, 7}, kAnotherNeighbour = {1, 16, 8};

class LeasesTest : public testing::Test {
 protected:
  /// @return Whether Fast DDS got it.
  bool receive(std::vector<unsigned char> message) {
    bool isHandedOn = false;
    leases_.receive(message, now_, [&](auto) { isHandedOn = true; });
    return isHandedOn;
  }

  /// Lets time pass as it does where the ends of leases are asked for in time.
  /// @return Those that ended.
  std::vector<GuidPrefix> pass(Leases::TimePoint::duration duration) {
    std::vector<GuidPrefix> ended;
    const auto end = now_ + duration;
    while (true) {
      const auto next = leases_.end(now_, [&](std::span<const unsigned char> message) {
        GuidPrefix& prefix = ended.emplace_back();
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

  Leases leases_;
  Leases::TimePoint now_ = Leases::TimePoint(std::chrono::hours(1));
};

TEST_F(LeasesTest, EndAfterSilenceOnly) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  ASSERT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .lease = 10})));
  EXPECT_TRUE(pass(milliseconds(4500)).empty());
  // anything that it says counts
  ASSERT_TRUE(receive(bytesOf(hostile::Packet(kNeighbour))));
  EXPECT_TRUE(pass(milliseconds(4900)).empty());
  EXPECT_EQ(pass(milliseconds(200)), std::vector{kNeighbour});
  EXPECT_EQ(pass(seconds(5)), std::vector{kAnotherNeighbour});
  EXPECT_EQ(leases_.size(), 0);
  EXPECT_TRUE(pass(seconds(20)).empty());
}

TEST_F(LeasesTest, OfAllWhoSpeakInAMessageGoOn) {
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

TEST_F(LeasesTest, RunOnForThoseWhoAnnounceThemForever) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 0x7fffffff})));
  EXPECT_TRUE(pass(std::chrono::hours(2)).empty());
  EXPECT_EQ(leases_.size(), 1);
}

TEST_F(LeasesTest, EndSoonWithAGoodbye) {
  for (const Goodbye form : {Goodbye::kWithHash, Goodbye::kWithKey}) {
    ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 1000})));
    ASSERT_TRUE(receive(announcementOf({.participant = kAnotherNeighbour, .lease = 1000})));
    ASSERT_TRUE(receive(goodbyeOf(kNeighbour, form))) << "Fast DDS may have understood it";
    EXPECT_EQ(pass(seconds(2)), std::vector{kNeighbour});
    EXPECT_EQ(leases_.size(), 1);
  }
  ASSERT_TRUE(receive(goodbyeOf(kNeighbour)));
  EXPECT_EQ(leases_.size(), 1) << "nobody is known by a goodbye";
}

TEST_F(LeasesTest, EndBeforeWhoWasSilentIsHeardAgain) {
  ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  now_ += seconds(6);
  EXPECT_FALSE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  EXPECT_FALSE(receive(bytesOf(hostile::Packet(kNeighbour))));
  EXPECT_FALSE(receive(goodbyeOf(kNeighbour)));
  std::size_t ended = 0;
  leases_.end(now_, [&](auto) { ++ended; });
  EXPECT_EQ(ended, 1);
  EXPECT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 5})));
  EXPECT_TRUE(receive(bytesOf(hostile::Packet(kNeighbour))));
}

TEST_F(LeasesTest, LetEachGoodbyeBeNewerThanTheLast) {
  std::vector<unsigned char> last;
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(receive(announcementOf({.participant = kNeighbour, .lease = 0})));
    now_ += milliseconds(100);
    std::vector<unsigned char> number;
    leases_.end(now_, [&](std::span<const unsigned char> message) {
      // of DATA: its upper half, then its lower half, least significant byte first
      const auto sequence = message.subspan(20 + 4 + 12, 8);
      for (const int at : {3, 2, 1, 0, 7, 6, 5, 4}) number.push_back(sequence[at]);
    });
    ASSERT_EQ(number.size(), 8);
    EXPECT_GT(number, last);
    last = number;
  }
}

TEST_F(LeasesTest, LetFastDdsHandleOneAnnouncementAtATime) {
  constexpr int kTimes = 200;
  const Leases::TimePoint begin = now_;
  std::atomic<int> inside = 0, most = 0;
  const auto handOn = [&](auto) {
    most = std::max(most.load(), ++inside);
    std::this_thread::yield();
    --inside;
  };
  const auto announce = [&](const GuidPrefix& prefix) {
    for (int i = 0; i < kTimes; ++i) {
      std::vector<unsigned char> message = announcementOf({.participant = prefix, .lease = 0});
      leases_.receive(message, begin, handOn);
    }
  };
  std::thread first([&] { announce(kNeighbour); }), second([&] { announce(kAnotherNeighbour); });
  for (int i = 0; i < kTimes; ++i) leases_.end(now_ += milliseconds(20), handOn);
  first.join();
  second.join();
  EXPECT_EQ(most, 1);
}

TEST_F(LeasesTest, LetDataPassMeanwhile) {
  std::vector<unsigned char> announcement = announcementOf({.participant = kNeighbour});
  bool isHandedOn = false;
  leases_.receive(announcement, now_, [&](auto) {
    std::thread([&] { isHandedOn = receive(bytesOf(hostile::Packet(kNeighbour))); }).join();
  });
  EXPECT_TRUE(isHandedOn);
}

TEST_F(LeasesTest, LetNothingPassThatCantBeRead) {
  EXPECT_FALSE(receive(announcementOf({.participant = kNeighbour, .lease = std::nullopt})));
  EXPECT_EQ(leases_.size(), 0);
}

}  // namespace
}  // namespace pongsim::ros2
