#include "cli/topic/spread.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::cli {
namespace {

TEST(Spread, TellsHowValuesLie) {
  const Spread spread = spreadOf({1, 5, 3, 3});
  EXPECT_EQ(spread.mean, 3);
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.most, 5);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(2.0));
}

TEST(Spread, OfOneValueIsNone) {
  const Spread spread = spreadOf({-2});
  EXPECT_EQ(spread.mean, -2);
  EXPECT_EQ(spread.most, -2);
  EXPECT_EQ(spread.deviation, 0);
}

}  // namespace
}  // namespace pongsim::cli
