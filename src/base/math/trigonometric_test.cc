#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

// near by, far away, and as far as numbers go
constexpr test::Range kAngles[] = {{-0.8, 0.8}, {-10, 10}, {-1e6, 1e6}, {-60, 20, true}, {20, 1023, true}};

TEST(Trigonometric, ErrsByLessThanALastPlace) {
  for (const test::Range& range : kAngles) {
    EXPECT_LT(test::worstError(
                  sin, [](long double x) { return std::sin(x); }, range),
              0.8)
        << range.high;
    EXPECT_LT(test::worstError(
                  cos, [](long double x) { return std::cos(x); }, range),
              0.8)
        << range.high;
    EXPECT_LT(test::worstError(
                  tan, [](long double x) { return std::tan(x); }, range),
              0.9)
        << range.high;
  }
}

TEST(Trigonometric, GivesSineAndCosineAtOnceWithTheSameBits) {
  Random random(1, "angles");
  for (const test::Range& range : kAngles) {
    for (int i = 0; i < 10'000; ++i) {
      const double angle = test::drawn(random, range);
      const auto [sine, cosine] = sinCos(angle);
      ASSERT_EQ(sine, sin(angle)) << angle;
      ASSERT_EQ(cosine, cos(angle)) << angle;
    }
  }
}

TEST(Trigonometric, IsExactAtNothing) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(std::signbit(sin(zero)), std::signbit(zero));
    EXPECT_EQ(std::signbit(tan(zero)), std::signbit(zero));
    EXPECT_EQ(sin(zero), 0);
    EXPECT_EQ(cos(zero), 1);
  }
  EXPECT_EQ(sin(std::numbers::pi / 2), 1);
  EXPECT_EQ(sin(std::numbers::pi), 1.2246467991473532e-16);
}

TEST(Trigonometric, HasNoValueAtInfinity) {
  for (const double angle : {test::kInfinity, -test::kInfinity, test::kNaN}) {
    EXPECT_TRUE(std::isnan(sin(angle)));
    EXPECT_TRUE(std::isnan(cos(angle)));
    EXPECT_TRUE(std::isnan(tan(angle)));
    EXPECT_TRUE(std::isnan(sinCos(angle).sine));
  }
}

}  // namespace
}  // namespace pongsim::math
