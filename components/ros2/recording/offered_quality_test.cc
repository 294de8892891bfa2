#include "ros2/recording/offered_quality.hh"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace pongsim::ros2 {
namespace {

// in the format that rosbag2 reads (rosbag2_storage/qos.cpp)
TEST(OfferedQuality, HasTheNumbersOfRmw) {
  const YAML::Node list = YAML::Load(offeredQuality(kDefaultQos));
  ASSERT_EQ(list.size(), 1U);
  const YAML::Node usual = list[0];
  EXPECT_EQ(usual["history"].as<int>(), 1);
  EXPECT_EQ(usual["depth"].as<int>(), 10);
  EXPECT_EQ(usual["reliability"].as<int>(), 1);
  EXPECT_EQ(usual["durability"].as<int>(), 2);
  EXPECT_EQ(usual["liveliness"].as<int>(), 1);
  EXPECT_FALSE(usual["avoid_ros_namespace_conventions"].as<bool>());
  for (const char* name : {"deadline", "lifespan", "liveliness_lease_duration"}) {
    EXPECT_EQ(usual[name]["sec"].as<std::uint64_t>(), 9223372036U) << name;
    EXPECT_EQ(usual[name]["nsec"].as<std::uint64_t>(), 854775807U) << name;
  }
  const YAML::Node sensor = YAML::Load(offeredQuality(kSensorQos))[0];
  EXPECT_EQ(sensor["reliability"].as<int>(), 2);
  EXPECT_EQ(sensor["depth"].as<int>(), 5);
  const YAML::Node latched =
      YAML::Load(offeredQuality({.isTransientLocal = true, .depth = 1, .lifespan = std::chrono::seconds(7)}))[0];
  EXPECT_EQ(latched["durability"].as<int>(), 1);
  EXPECT_EQ(latched["lifespan"]["sec"].as<int>(), 7);
  EXPECT_EQ(latched["lifespan"]["nsec"].as<int>(), 0);
}

}  // namespace
}  // namespace pongsim::ros2
