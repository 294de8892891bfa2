#include "video/frame_clock.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace pongsim::video {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

TEST(FrameClock, TakesOneImageForEachFrame) {
  FrameClock clock(25);
  std::vector<std::int64_t> frames;
  // at 100 Hz
  for (int i = 0; i < 20; ++i) {
    if (const auto frame = clock.frameOf(milliseconds(5000 + 10 * i))) frames.push_back(*frame);
  }
  EXPECT_EQ(frames, (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(clock.length(), milliseconds(190));
}

TEST(FrameClock, LeavesOutFramesWithoutImages) {
  FrameClock clock(10);
  EXPECT_EQ(clock.frameOf(milliseconds(0)), 0);
  EXPECT_EQ(clock.frameOf(milliseconds(1050)), 10);
  EXPECT_EQ(clock.frameOf(hours(100'000)), 3'600'000'000);
}

TEST(FrameClock, GoesOnWhereTheTimeGoesBack) {
  FrameClock clock(10);
  EXPECT_EQ(clock.frameOf(milliseconds(700)), 0);
  EXPECT_EQ(clock.frameOf(milliseconds(1000)), 3);
  EXPECT_EQ(clock.frameOf(milliseconds(100)), 4);
  EXPECT_EQ(clock.frameOf(milliseconds(200)), 5);
}

}  // namespace
}  // namespace pongsim::video
