#include "transport/udp/announcements.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <vector>

namespace pongsim::transport {

namespace {

using namespace std::chrono_literals;

/// Announcements on a machine with two open ports; the test sets the time.
class AnnouncementsTest : public testing::Test {
 protected:
  bool goesTo(std::uint32_t port, std::uint64_t sequence = 1) { return announcements_.goesTo(port, sequence, now_); }

  std::optional<std::vector<std::uint32_t>> open_ = std::vector<std::uint32_t>{7410, 7412};
  int queries_ = 0;
  Announcements::TimePoint now_{};
  Announcements announcements_{[this] {
    ++queries_;
    return open_;
  }};
};

}  // namespace

TEST_F(AnnouncementsTest, GoToEachOpenPortOnceASecond) {
  EXPECT_TRUE(goesTo(7410));
  EXPECT_TRUE(goesTo(7412));
  EXPECT_FALSE(goesTo(7414)) << "closed";
  now_ += 999ms;
  EXPECT_FALSE(goesTo(7410));
  now_ += 1ms;
  EXPECT_TRUE(goesTo(7410));
}

TEST_F(AnnouncementsTest, GoAtOnceIfTheSequenceNumberIsNew) {
  EXPECT_TRUE(goesTo(7410));
  EXPECT_TRUE(goesTo(7410, 2));
  EXPECT_FALSE(goesTo(7410, 2));
}

TEST_F(AnnouncementsTest, GoOnceMoreToAParticipantThatHasBeenDiscovered) {
  EXPECT_TRUE(goesTo(7410));
  EXPECT_TRUE(goesTo(7412));
  announcements_.discovered(7412);
  EXPECT_FALSE(goesTo(7410));
  EXPECT_TRUE(goesTo(7412));
  EXPECT_FALSE(goesTo(7412));
}

TEST_F(AnnouncementsTest, GoToADiscoveredParticipantWhosePortIsNotListedYet) {
  EXPECT_FALSE(goesTo(7414));
  announcements_.discovered(7414);
  EXPECT_TRUE(goesTo(7414));
  EXPECT_EQ(queries_, 1);
}

TEST_F(AnnouncementsTest, GoToPortsThatHaveBeenOpenedSince) {
  EXPECT_FALSE(goesTo(7414));
  open_->push_back(7414);
  now_ += 100ms;
  EXPECT_TRUE(goesTo(7414));
}

TEST_F(AnnouncementsTest, ListTheOpenPortsOnceForAll) {
  for (std::uint32_t port = 7410; port < 7600; port += 2) goesTo(port);
  EXPECT_EQ(queries_, 1);
}

TEST_F(AnnouncementsTest, GoToAllPortsWhereTheSystemReportsNone) {
  open_.reset();
  EXPECT_TRUE(goesTo(7414));
}

TEST_F(AnnouncementsTest, GoToNobodyOfTheSameProcess) {
  announcements_.ignore(7410);
  announcements_.discovered(7410);
  EXPECT_FALSE(goesTo(7410));
  EXPECT_TRUE(goesTo(7412));
}

}  // namespace pongsim::transport
