#include "transport/udp/heartbeats.hh"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <map>

namespace pongsim::transport {

namespace {

using namespace std::chrono_literals;

/// Heartbeats to participants whose acknowledgements the test sets, as it does the time.
class HeartbeatsTest : public testing::Test {
 protected:
  bool goTo(std::uint32_t port, std::uint64_t last, shared::RtpsEntity writer = shared::kPublicationsWriter) {
    return heartbeats_.goTo(port, std::array{shared::RtpsHeartbeat{writer, last}}, now_);
  }

  std::map<std::uint32_t, std::uint64_t> acknowledged_;
  Heartbeats::TimePoint now_{};
  Heartbeats heartbeats_{[this](std::uint32_t port, const shared::RtpsHeartbeat& heartbeat) {
    const auto found = acknowledged_.find(port);
    return found != acknowledged_.end() && found->second >= heartbeat.last;
  }};
};

}  // namespace

TEST_F(HeartbeatsTest, GoOncePerPeriodToWhoHasNotAcknowledged) {
  EXPECT_TRUE(goTo(7410, 5));
  EXPECT_TRUE(goTo(7412, 5));
  EXPECT_FALSE(goTo(7410, 5));
  now_ += 1s;
  EXPECT_TRUE(goTo(7410, 5));
}

TEST_F(HeartbeatsTest, GoAtOnceWhereTheyTellOfMore) {
  EXPECT_TRUE(goTo(7410, 5));
  EXPECT_TRUE(goTo(7410, 6));
}

TEST_F(HeartbeatsTest, GoForEachWriter) {
  EXPECT_TRUE(goTo(7410, 5));
  EXPECT_TRUE(goTo(7410, 5, shared::kSubscriptionsWriter));
  now_ += 1s;
  const std::array both{shared::RtpsHeartbeat{shared::kPublicationsWriter, 5},
                        shared::RtpsHeartbeat{shared::kSubscriptionsWriter, 5}};
  EXPECT_TRUE(goTo(7410, 5));
  EXPECT_TRUE(heartbeats_.goTo(7410, both, now_)) << "the second one is due";
  EXPECT_FALSE(heartbeats_.goTo(7410, both, now_));
}

TEST_F(HeartbeatsTest, DoNotGoToWhoHasAcknowledgedAll) {
  acknowledged_[7410] = 5;
  EXPECT_FALSE(goTo(7410, 5));
  EXPECT_TRUE(goTo(7410, 6));
  EXPECT_TRUE(goTo(7412, 5));
}

}  // namespace pongsim::transport
