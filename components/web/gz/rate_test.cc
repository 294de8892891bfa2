#include "web/gz/rate.hh"

#include <gtest/gtest.h>

#include <limits>

namespace pongsim::web::gz {
namespace {

/// @return How many messages pass within a second, at that rate of arrival.
int passing(Rate& rate, int hz) {
  int count = 0;
  const Rate::Clock::time_point start{std::chrono::hours(1)};
  for (int i = 0; i < hz; ++i) count += rate.passes(start + std::chrono::nanoseconds(1'000'000'000LL * i / hz)) ? 1 : 0;
  return count;
}

TEST(Rate, LetsThroughSoManyASecond) {
  Rate rate(60);
  EXPECT_NEAR(passing(rate, 1000), 60, 2);
}

TEST(Rate, LetsThroughAllThatComeNoMoreOften) {
  Rate rate(60);
  EXPECT_EQ(passing(rate, 60), 60);
  Rate slow(60);
  EXPECT_EQ(passing(slow, 7), 7);
}

TEST(Rate, MayChangeAndMayBeNone) {
  Rate rate(60);
  rate.set(10);
  EXPECT_NEAR(passing(rate, 1000), 10, 2);
  Rate stuck(1e-6);
  EXPECT_EQ(passing(stuck, 1000), 1);
  stuck.set(60);
  EXPECT_GT(passing(stuck, 1000), 50);
  Rate none(std::numeric_limits<double>::infinity());
  EXPECT_EQ(passing(none, 1000), 1000);
  Rate hardlyAny(1e-300);
  EXPECT_EQ(passing(hardlyAny, 1000), 1);
}

}  // namespace
}  // namespace pongsim::web::gz
