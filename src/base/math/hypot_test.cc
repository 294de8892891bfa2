#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

TEST(Hypot, ErrsByLessThanALastPlace) {
  Random random(1, "points");
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = test::drawn(random, {-1000, 950, true}), y = x * test::drawn(random, {-64, 64, true});
    worst = std::max(worst, test::lastPlaces(hypot(x, y), std::hypot(static_cast<long double>(x), y)));
  }
  EXPECT_LT(worst, 1);
}

TEST(Hypot, IsExactWhereTheLengthIsANumber) {
  EXPECT_EQ(hypot(3, -4), 5);
  EXPECT_EQ(hypot(0, -2), 2);
  EXPECT_EQ(hypot(3e-320, 4e-320), 5e-320);
  EXPECT_EQ(hypot(0x1p1023, 0x1p1023), 0x1.6a09e667f3bcdp1023);
  EXPECT_EQ(hypot(1.7e308, 1.7e308), test::kInfinity);
}

TEST(Hypot, IsInfiniteWhateverTheOtherIs) {
  EXPECT_EQ(hypot(-test::kInfinity, test::kNaN), test::kInfinity);
  EXPECT_EQ(hypot(test::kNaN, test::kInfinity), test::kInfinity);
  EXPECT_TRUE(std::isnan(hypot(test::kNaN, 1)));
}

}  // namespace
}  // namespace pongsim::math
