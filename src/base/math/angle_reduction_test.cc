#include "base/math/angle_reduction.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim::math {
namespace {

TEST(AngleReduction, LeavesAnEighthOfATurnAtMost) {
  for (const double angle : {0.8, -3.0, 1e3, -1e6, 1048575.9, 1048576.0, 1e15, -1e100, 1.7e308}) {
    const ReducedAngle reduced = reduceAngle(angle);
    EXPECT_LE(std::abs(reduced.rest), std::numbers::pi / 4 + 1e-12) << angle;
    EXPECT_LE(std::abs(reduced.tail), std::abs(reduced.rest) * 0x1p-52) << angle;
    EXPECT_LT(reduced.quarters, 4U);
  }
}

// the one double that is nearest to a multiple of pi/2: Muller, Elementary Functions, 11.4
TEST(AngleReduction, KeepsAllDigitsNextToAQuarterTurn) {
  const ReducedAngle reduced = reduceAngle(0x1.6ac5b262ca1ffp+849);
  EXPECT_EQ(reduced.rest, 0x1.14ae72e6ba22fp-61) << std::hexfloat << reduced.rest;
}

TEST(AngleReduction, IsOddAndTheSameOnBothSidesOfItsMethods) {
  const double border = 0x1p20;
  const ReducedAngle below = reduceAngle(std::nextafter(border, 0)), above = reduceAngle(border);
  EXPECT_EQ(below.quarters, above.quarters);
  EXPECT_NEAR(above.rest - below.rest, border - std::nextafter(border, 0), 1e-16);
  const ReducedAngle back = reduceAngle(-border);
  EXPECT_EQ(back.rest, -above.rest);
  EXPECT_EQ(back.quarters, (4 - above.quarters) & 3U);
}

}  // namespace
}  // namespace pongsim::math
