#include <gtest/gtest.h>

#include <cmath>

#include "pongsim/math.hh"
#include "support/base/last_places.hh"

namespace pongsim::math {
namespace {

TEST(ErrorFunction, ErrsByLessThanPromised) {
  Random random(1, "numbers");
  for (int i = 0; i < 20'000; ++i) {
    const double number = test::drawn(random, {-6, 26});
    const double exact = static_cast<double>(std::erfc(static_cast<long double>(number)));
    ASSERT_NEAR(erfc(number) / exact, 1, 1e-13) << number;
  }
}

TEST(ErrorFunction, KnowsWhereItEnds) {
  EXPECT_EQ(erfc(0), 1);
  EXPECT_EQ(erfc(30), 0);
  EXPECT_EQ(erfc(test::kInfinity), 0);
  EXPECT_EQ(erfc(-test::kInfinity), 2);
  EXPECT_TRUE(std::isnan(erfc(test::kNaN)));
}

}  // namespace
}  // namespace pongsim::math
