#include "message_noise.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/laserscan.pb.h>

#include <cmath>
#include <limits>

namespace pongsim::faults {
namespace {

TEST(MessageNoise, IsNormalAndLeavesHeadersAndInfinityAlone) {
  ignition::msgs::LaserScan scan;
  scan.mutable_header()->mutable_stamp()->set_sec(3);
  constexpr int kCount = 10'000;
  for (int i = 0; i < kCount; ++i) scan.add_ranges(5);
  scan.add_ranges(std::numeric_limits<double>::infinity());
  Random random(1, "noise");
  ASSERT_TRUE(addNoise(scan, "ranges", 0.2, random));
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    sum += scan.ranges(i) - 5;
    squares += std::pow(scan.ranges(i) - 5, 2);
  }
  // five times the standard errors of mean and deviation
  EXPECT_NEAR(sum / kCount, 0, 5 * 0.2 / std::sqrt(kCount));
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.2, 5 * 0.2 / std::sqrt(2.0 * kCount));
  EXPECT_TRUE(std::isinf(scan.ranges(kCount)));
  EXPECT_EQ(scan.header().stamp().sec(), 3);
  EXPECT_EQ(scan.angle_min(), 0);
}

TEST(MessageNoise, GoesToAFieldOrToAll) {
  ignition::msgs::IMU imu;
  imu.mutable_angular_velocity()->set_x(1);
  imu.mutable_linear_acceleration()->set_x(1);
  Random random(1, "noise");
  ASSERT_TRUE(addNoise(imu, "angular_velocity.z", 1, random));
  EXPECT_NE(imu.angular_velocity().z(), 0);
  EXPECT_EQ(imu.angular_velocity().x(), 1);
  ASSERT_TRUE(addNoise(imu, "angular_velocity", 1, random));
  EXPECT_NE(imu.angular_velocity().x(), 1);
  EXPECT_EQ(imu.linear_acceleration().x(), 1);
  ASSERT_TRUE(addNoise(imu, "", 1, random));
  EXPECT_NE(imu.linear_acceleration().x(), 1);
  EXPECT_FALSE(addNoise(imu, "angular_speed", 1, random));
  EXPECT_FALSE(addNoise(imu, "angular_velocity.w", 1, random));
  EXPECT_FALSE(addNoise(imu, "entity_name", 1, random));
}

}  // namespace
}  // namespace pongsim::faults
