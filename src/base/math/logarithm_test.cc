#include <gtest/gtest.h>

#include <cmath>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

TEST(Logarithm, ErrsByLessThanALastPlace) {
  for (const test::Range& range : {test::Range{0.5, 2}, test::Range{1e-320, 1e-300}, test::Range{1, 1e300}}) {
    EXPECT_LT(test::worstError(
                  log, [](long double x) { return std::log(x); }, range),
              0.9)
        << range.high;
  }
  for (const test::Range& range : {test::Range{-0.999, 1}, test::Range{-1, 1e6}, test::Range{-70, -1, true}}) {
    EXPECT_LT(test::worstError(
                  log1p, [](long double x) { return std::log1p(x); }, range),
              0.9)
        << range.high;
  }
}

TEST(Logarithm, KnowsWhereItEnds) {
  EXPECT_EQ(log(1), 0);
  EXPECT_EQ(log(0), -test::kInfinity);
  EXPECT_EQ(log(test::kInfinity), test::kInfinity);
  EXPECT_TRUE(std::isnan(log(-1)));
  EXPECT_EQ(log1p(-1), -test::kInfinity);
  EXPECT_EQ(log1p(test::kInfinity), test::kInfinity);
  EXPECT_TRUE(std::signbit(log1p(-0.0)));
  EXPECT_TRUE(std::isnan(log1p(-1.1)));
  EXPECT_TRUE(std::isnan(log(test::kNaN)));
  EXPECT_TRUE(std::isnan(log1p(test::kNaN)));
}

}  // namespace
}  // namespace pongsim::math
