#include "ros2/config/quality.hh"

#include <gtest/gtest.h>

#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {
namespace {

TopicRule ruleOf(const char* ros, const char* ignition) {
  TopicRule rule;
  rule.pair = findPair(ros, ignition);
  return rule;
}

TEST(Quality, IsWhatUsersExpectWhereNobodySays) {
  const TopicRule scan = ruleOf("sensor_msgs/msg/LaserScan", "ignition.msgs.LaserScan");
  EXPECT_EQ(writerQos(scan, false), (Qos{.isReliable = true, .isTransientLocal = false, .depth = 10}));
  EXPECT_EQ(writerQos(scan, true), (Qos{.isReliable = true, .isTransientLocal = true, .depth = 1}));
  EXPECT_EQ(readerQos(scan), (Qos{.isReliable = false, .isTransientLocal = false, .depth = 10}));
  const TopicRule transforms = ruleOf("tf2_msgs/msg/TFMessage", "ignition.msgs.Pose_V");
  EXPECT_EQ(writerQos(transforms, false).depth, 100U);
  EXPECT_EQ(writerQos(transforms, true).depth, 1U);
}

TEST(Quality, IsWhatTheRuleSays) {
  TopicRule rule = ruleOf("tf2_msgs/msg/TFMessage", "ignition.msgs.Pose_V");
  rule.toRos = {.depth = 3, .isReliable = false, .isTransientLocal = false};
  rule.fromRos = {.depth = 4, .isReliable = true, .isTransientLocal = true};
  EXPECT_EQ(writerQos(rule, true), (Qos{.isReliable = false, .isTransientLocal = false, .depth = 3}));
  EXPECT_EQ(readerQos(rule), (Qos{.isReliable = true, .isTransientLocal = true, .depth = 4}));
}

TEST(Quality, IsLazyUnlessLateNodesAreToHearWhatWasSaid) {
  TopicRule rule = ruleOf("std_msgs/msg/String", "ignition.msgs.StringMsg");
  EXPECT_TRUE(isLazyToRos(rule, false));
  EXPECT_FALSE(isLazyToRos(rule, true));
  EXPECT_FALSE(isLazyFromRos(rule));
  rule.toRos.isTransientLocal = true;
  EXPECT_FALSE(isLazyToRos(rule, false));
  rule.toRos.isLazy = rule.fromRos.isLazy = true;
  EXPECT_TRUE(isLazyToRos(rule, false));
  EXPECT_TRUE(isLazyFromRos(rule));
}

}  // namespace
}  // namespace pongsim::ros2
