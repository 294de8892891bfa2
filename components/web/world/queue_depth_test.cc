#include "web/world/queue_depth.hh"

#include <gtest/gtest.h>

namespace pongsim::web {
namespace {

TEST(MostWaiting, IsOneOfAStateAndMoreOfEvents) {
  EXPECT_EQ(queueDepth("ignition.msgs.Image"), 1U);
  EXPECT_EQ(queueDepth("ignition.msgs.Pose_V"), 1U);
  EXPECT_GT(queueDepth("ignition.msgs.IMU"), 1U);
  EXPECT_GT(queueDepth("ignition.msgs.StringMsg"), 1U);
  // an array of markers is told one by one
  EXPECT_EQ(queueDepth("ignition.msgs.Marker"), 10'000U);
}

}  // namespace
}  // namespace pongsim::web
