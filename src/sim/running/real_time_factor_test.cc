#include "sim/running/real_time_factor.hh"

#include <gtest/gtest.h>

namespace pongsim::sim {
namespace {

using std::chrono::milliseconds;

RealTimeFactor::WallTime wall(int ms) { return RealTimeFactor::WallTime(milliseconds(ms)); }

TEST(RealTimeFactor, IsZeroBeforeThereIsSomethingToCompare) {
  RealTimeFactor factor;
  EXPECT_EQ(factor.value(), 0);
  factor.sample(wall(0), milliseconds(0));
  EXPECT_EQ(factor.value(), 0);
}

TEST(RealTimeFactor, IsSimulatedTimeByWallTime) {
  RealTimeFactor factor;
  for (int ms = 0; ms <= 1000; ++ms) factor.sample(wall(ms), milliseconds(3 * ms));
  EXPECT_DOUBLE_EQ(factor.value(), 3);
}

TEST(RealTimeFactor, ForgetsWhatIsLongAgo) {
  RealTimeFactor factor;
  for (int ms = 0; ms <= 2000; ++ms) factor.sample(wall(ms), milliseconds(3 * ms));
  for (int ms = 2000; ms <= 4000; ++ms) factor.sample(wall(ms), milliseconds(6000 + (ms - 2000)));
  EXPECT_DOUBLE_EQ(factor.value(), 1);
}

}  // namespace
}  // namespace pongsim::sim
