#include "pongsim/control/speed_limiter.hh"

#include <gtest/gtest.h>

namespace pongsim {
namespace {

TEST(SpeedLimiter, PassesAnythingWithoutLimits) {
  SpeedLimiter limiter;
  EXPECT_EQ(limiter.limit(1e6, 0.001), 1e6);
  EXPECT_EQ(limiter.limit(-3.25, 0.001), -3.25);
}

TEST(SpeedLimiter, ClampsVelocityOnBothSides) {
  SpeedLimits limits;
  limits.minVelocity = -0.5;
  limits.maxVelocity = 1;
  SpeedLimiter limiter(limits);
  EXPECT_EQ(limiter.limit(2, 0.001), 1);
  EXPECT_EQ(limiter.limit(-2, 0.001), -0.5);
}

TEST(SpeedLimiter, RampsUpByTheAccelerationEachStep) {
  SpeedLimits limits;
  limits.maxAcceleration = 2;
  SpeedLimiter limiter(limits);
  EXPECT_DOUBLE_EQ(limiter.limit(1, 0.1), 0.2);
  EXPECT_DOUBLE_EQ(limiter.limit(1, 0.1), 0.4);
}

TEST(SpeedLimiter, LimitsJerkFromTheLastTwoVelocities) {
  SpeedLimits limits;
  limits.maxJerk = 10;
  SpeedLimiter limiter(limits);
  // a = j dt = 1 m/s^2 after the first step of 0.1 s, 2 after the second.
  EXPECT_NEAR(limiter.limit(100, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(limiter.limit(100, 0.1), 0.3, 1e-12);
}

TEST(SpeedLimiter, LimitsOnlyVelocityWhenNoTimePasses) {
  SpeedLimits limits;
  limits.maxAcceleration = 1;
  limits.maxVelocity = 5;
  SpeedLimiter limiter(limits);
  EXPECT_EQ(limiter.limit(9, 0), 5);
}

TEST(SpeedLimits, OfOneKindGoBeforeThoseOfAll) {
  SpeedLimitParameters all, own;
  all.maxVelocity = 2;
  all.minVelocity = -2;
  own.maxVelocity = 1;
  const SpeedLimits limits = speedLimits(own, all, "linear", {});
  EXPECT_EQ(limits.maxVelocity, 1);
  EXPECT_EQ(limits.minVelocity, -2);
  EXPECT_EQ(limits.maxJerk, std::numeric_limits<double>::infinity());
  own.maxVelocity = -3;
  EXPECT_THROW(speedLimits(own, all, "linear", {}), Error);
}

}  // namespace
}  // namespace pongsim
