#include "web/world/waiting.hh"

#include <gtest/gtest.h>

namespace pongsim::web {
namespace {

TEST(MostWaiting, IsOneOfAStateAndMoreOfEvents) {
  EXPECT_EQ(mostWaiting("ignition.msgs.Image"), 1U);
  EXPECT_EQ(mostWaiting("ignition.msgs.Pose_V"), 1U);
  EXPECT_GT(mostWaiting("ignition.msgs.IMU"), 1U);
  EXPECT_GT(mostWaiting("ignition.msgs.StringMsg"), 1U);
}

}  // namespace
}  // namespace pongsim::web
