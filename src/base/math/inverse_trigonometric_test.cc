#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

TEST(InverseTrigonometric, ErrsByLessThanALastPlace) {
  for (const test::Range& range : {test::Range{-1, 1}, test::Range{-40, 0, true}}) {
    EXPECT_LT(test::worstError(
                  asin, [](long double x) { return std::asin(x); }, range),
              0.9);
    EXPECT_LT(test::worstError(
                  acos, [](long double x) { return std::acos(x); }, range),
              0.9);
  }
  for (const test::Range& range : {test::Range{-5, 5}, test::Range{-70, 70, true}}) {
    EXPECT_LT(test::worstError(
                  atan, [](long double x) { return std::atan(x); }, range),
              0.9);
  }
}

TEST(InverseTrigonometric, TellsTheAngleOfAPoint) {
  Random random(1, "points");
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = test::drawn(random, {-600, 600, true}), y = x * test::drawn(random, {-8, 8, true});
    worst = std::max(worst, test::lastPlaces(atan2(y, x), std::atan2(static_cast<long double>(y), x)));
  }
  EXPECT_LT(worst, 1.5);
}

// IEEE 754, as annex F of the C standard has it
TEST(InverseTrigonometric, KnowsTheSpecialPoints) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, test::kInfinity, -test::kInfinity, 1e-320, -1e308}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, test::kInfinity, -test::kInfinity, 1e-320, -1e308}) {
      EXPECT_EQ(atan2(y, x), std::atan2(y, x)) << y << ", " << x;
      EXPECT_EQ(std::signbit(atan2(y, x)), std::signbit(y)) << y << ", " << x;
    }
    EXPECT_TRUE(std::isnan(atan2(y, test::kNaN)));
    EXPECT_TRUE(std::isnan(atan2(test::kNaN, y)));
  }
}

TEST(InverseTrigonometric, EndsWhereSineAndCosineDo) {
  EXPECT_EQ(asin(1), std::asin(1.0));
  EXPECT_EQ(asin(-1), -std::asin(1.0));
  EXPECT_EQ(acos(1), 0);
  EXPECT_EQ(acos(-1), std::acos(-1.0));
  EXPECT_EQ(atan(-test::kInfinity), -std::asin(1.0));
  EXPECT_TRUE(std::signbit(asin(-0.0)));
  EXPECT_TRUE(std::signbit(atan(-0.0)));
  for (const double beyond : {std::nextafter(1, 2), -2.0, test::kInfinity, test::kNaN}) {
    EXPECT_TRUE(std::isnan(asin(beyond)));
    EXPECT_TRUE(std::isnan(acos(beyond)));
  }
}

}  // namespace
}  // namespace pongsim::math
