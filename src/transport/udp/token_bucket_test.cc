#include "transport/udp/token_bucket.hh"

#include <gtest/gtest.h>

#include <chrono>

namespace pongsim::transport {
namespace {

TEST(TokenBucket, IsFullAtFirstAndGainsTokensUpToItsCapacity) {
  TokenBucket bucket(10, 2);
  TokenBucket::TimePoint now{};
  EXPECT_TRUE(bucket.take(8, now));
  EXPECT_FALSE(bucket.take(3, now)) << "two are left";
  EXPECT_TRUE(bucket.take(2, now)) << "a refusal takes none";
  now += std::chrono::milliseconds(1500);
  EXPECT_TRUE(bucket.take(3, now));
  EXPECT_FALSE(bucket.take(0.5, now));
  now += std::chrono::hours(1);
  EXPECT_FALSE(bucket.take(10.5, now));
  EXPECT_TRUE(bucket.take(10, now));
}

}  // namespace
}  // namespace pongsim::transport
