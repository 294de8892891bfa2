#include <gtest/gtest.h>

#include <cmath>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

TEST(Exponential, ErrsByLessThanALastPlace) {
  for (const test::Range& range :
       {test::Range{-5, 5}, test::Range{-708, 709}, test::Range{-745, -708}, test::Range{-70, 9, true}}) {
    EXPECT_LT(test::worstError(
                  exp, [](long double x) { return std::exp(x); }, range),
              0.9)
        << range.low;
  }
  for (const test::Range& range : {test::Range{-1, 1}, test::Range{-40, 709}, test::Range{-60, 9, true}}) {
    EXPECT_LT(test::worstError(
                  expm1, [](long double x) { return std::expm1(x); }, range),
              0.9)
        << range.low;
  }
}

TEST(Exponential, KnowsWhereItEnds) {
  EXPECT_EQ(exp(0), 1);
  EXPECT_EQ(exp(test::kInfinity), test::kInfinity);
  EXPECT_EQ(exp(709.8), test::kInfinity);
  EXPECT_EQ(exp(-745.2), 0);
  EXPECT_EQ(exp(-test::kInfinity), 0);
  EXPECT_EQ(expm1(test::kInfinity), test::kInfinity);
  EXPECT_EQ(expm1(-test::kInfinity), -1);
  EXPECT_TRUE(std::signbit(expm1(-0.0)));
  EXPECT_TRUE(std::isnan(exp(test::kNaN)));
  EXPECT_TRUE(std::isnan(expm1(test::kNaN)));
}

}  // namespace
}  // namespace pongsim::math
