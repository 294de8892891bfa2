#include "ros2/controllers/wheel_odometry.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::ros2 {
namespace {

TEST(WheelOdometry, FollowsTheArcOfACircle) {
  WheelOdometry odometry;
  const double v = 0.5, w = 0.4, t = 5;
  for (int i = 0; i < 500; ++i) odometry.advance(v, w, 0.01);
  EXPECT_NEAR(odometry.x(), v / w * std::sin(w * t), 1e-9);
  EXPECT_NEAR(odometry.y(), v / w * (1 - std::cos(w * t)), 1e-9);
  EXPECT_NEAR(odometry.heading(), w * t, 1e-9);
}

TEST(WheelOdometry, GoesStraight) {
  WheelOdometry odometry;
  odometry.advance(0, 1, 0.5);
  odometry.advance(2, 0, 0.5);
  EXPECT_NEAR(odometry.x(), std::cos(0.5), 1e-12);
  EXPECT_NEAR(odometry.y(), std::sin(0.5), 1e-12);
  odometry.reset();
  odometry.advanceStraight(0, 1, 0, 0.5);
  EXPECT_NEAR(odometry.y(), 0.5, 1e-12);
}

TEST(WheelOdometry, AveragesTheLastVelocities) {
  WheelOdometry odometry(3);
  for (const double v : {1.0, 2.0, 3.0, 4.0}) odometry.average(v, -v);
  EXPECT_NEAR(odometry.linear(), 3, 1e-12);
  EXPECT_NEAR(odometry.angular(), -3, 1e-12);
  StateArchive saved;
  saved(odometry);
  const auto bytes = saved.take();
  WheelOdometry other(3);
  StateArchive given(bytes);
  given(other);
  other.average(5, 0);
  EXPECT_NEAR(other.linear(), 4, 1e-12);
  // with another window it is not its state
  WheelOdometry shorter(2);
  StateArchive again(bytes);
  EXPECT_THROW(again(shorter), std::out_of_range);
}

}  // namespace
}  // namespace pongsim::ros2
