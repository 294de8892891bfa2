#include "pongsim/control/rolling_mean.hh"

#include <gtest/gtest.h>

namespace pongsim {
namespace {

TEST(RollingMean, IsThatOfTheLastValues) {
  RollingMean<3> mean;
  EXPECT_EQ(mean.mean(), 0);
  mean.add(1);
  EXPECT_EQ(mean.mean(), 1);
  mean.add(2);
  mean.add(6);
  EXPECT_EQ(mean.mean(), 3);
  mean.add(7);
  EXPECT_EQ(mean.mean(), 5);
}

}  // namespace
}  // namespace pongsim
