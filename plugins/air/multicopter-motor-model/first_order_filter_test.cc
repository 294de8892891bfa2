#include "first_order_filter.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::first_order_filter_test {
namespace {

TEST(FirstOrderFilter, ReachesTheSameValueWhateverTheStep) {
  FirstOrderFilter fine(0.2, 0.4), coarse(0.2, 0.4);
  for (int i = 0; i < 100; ++i) fine.update(5, 0.002);
  coarse.update(5, 0.2);
  EXPECT_NEAR(fine.value(), 5 * (1 - std::exp(-1)), 1e-12);
  EXPECT_NEAR(coarse.value(), fine.value(), 1e-12);
}

TEST(FirstOrderFilter, FallsWithATimeConstantOfItsOwn) {
  FirstOrderFilter filter(0.2, 0.4);
  filter.update(3, 100);
  EXPECT_DOUBLE_EQ(filter.update(-1, 0.4), -1 + 4 * std::exp(-1));
}

TEST(FirstOrderFilter, FollowsAtOnceWithoutATimeConstant) {
  FirstOrderFilter filter(0, 0);
  EXPECT_EQ(filter.update(7, 0.001), 7);
  EXPECT_EQ(filter.update(-7, 0.001), -7);
  EXPECT_EQ(filter.update(-7, 0.001), -7);
}

TEST(FirstOrderFilter, StartsAnew) {
  FirstOrderFilter filter(1, 1);
  filter.update(7, 1);
  filter.reset();
  EXPECT_EQ(filter.value(), 0);
}

}  // namespace
}  // namespace pongsim::first_order_filter_test
