#include "ros2/robot/stamps.hh"

#include <gtest/gtest.h>

namespace pongsim::ros2 {
namespace {

TEST(Stamps, AreOfTheSimulationOrOfTheWall) {
  EXPECT_EQ(stampOf(fromSeconds(2.5), {}), (builtin_interfaces::Time{2, 500'000'000}));
  EXPECT_GT(stampOf(fromSeconds(2.5), {.usesWallTime = true}).sec, 1'600'000'000);
}

}  // namespace
}  // namespace pongsim::ros2
