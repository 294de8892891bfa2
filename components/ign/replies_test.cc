#include "ign/replies.hh"

#include <gtest/gtest.h>

#include <chrono>

namespace pongsim::ign {
namespace {

using Clock = std::chrono::steady_clock;

TEST(RepliesTest, GivesTheLastReplyTimeToLeave) {
  const Clock::time_point begin = Clock::now();
  replyGiven();
  awaitReplies();
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(500));

  const Clock::time_point again = Clock::now();
  awaitReplies();
  EXPECT_LT(Clock::now() - again, std::chrono::seconds(30)) << "nothing is left to wait for";
}

}  // namespace
}  // namespace pongsim::ign
