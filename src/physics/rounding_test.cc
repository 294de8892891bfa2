#include "physics/rounding.hh"

#include <gtest/gtest.h>

namespace pongsim::physics {
namespace {

TEST(Rounding, TakesToTheNearestMultiple) {
  EXPECT_EQ(roundedVelocity(3 * kRounded), 3 * kRounded);
  EXPECT_EQ(roundedVelocity(3.2 * kRounded), 3 * kRounded);
  EXPECT_EQ(roundedVelocity(-3.7 * kRounded), -4 * kRounded);
  EXPECT_EQ(roundedVelocity(0.4 * kRounded), 0);
  EXPECT_NEAR(roundedVelocity(0.123456789012345678), 0.123456789012345678, kRounded / 2);
}

TEST(Rounding, LeavesWhatIsLargeAsItIs) {
  for (const double value : {1.0000000000000002, 2.0000000000000004, -1234.5678901234567, 1e300}) {
    EXPECT_EQ(roundedVelocity(value), value);
  }
}

}  // namespace
}  // namespace pongsim::physics
