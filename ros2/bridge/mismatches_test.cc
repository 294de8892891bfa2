#include "ros2/bridge/mismatches.hh"

#include <gtest/gtest.h>

#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {
namespace {

constexpr Qos kBestEffort{.isReliable = false};

Offer commands(const Qos& reader = kAnyWriterQos) {
  return {"/cmd_vel", "/cmd_vel", findPair("geometry_msgs/msg/Twist", "ignition.msgs.Twist"), std::nullopt, reader};
}
Offer scans(const Qos& writer = kDefaultQos) {
  return {"/scan", "/lidar", findPair("sensor_msgs/msg/LaserScan", "ignition.msgs.LaserScan"), writer, std::nullopt};
}
Graph::Endpoint writer(const char* topic, const char* type, const Qos& qos = kDefaultQos) {
  return {{}, Graph::Role::kWriter, {topic, type, "", qos}};
}
Graph::Endpoint reader(const char* topic, const char* type, const Qos& qos = kDefaultQos) {
  return {{}, Graph::Role::kReader, {topic, type, "", qos}};
}
constexpr const char* kTwist = "geometry_msgs::msg::dds_::Twist_";
constexpr const char* kScan = "sensor_msgs::msg::dds_::LaserScan_";

TEST(Mismatch, IsNoneWhereTheyMeet) {
  EXPECT_EQ(mismatch(commands(), writer("rt/cmd_vel", kTwist)), std::nullopt);
  EXPECT_EQ(mismatch(commands(), writer("rt/cmd_vel", kTwist, kBestEffort)), std::nullopt);
  EXPECT_EQ(mismatch(scans(), reader("rt/scan", kScan)), std::nullopt);
  EXPECT_EQ(mismatch(scans(kBestEffort), reader("rt/scan", kScan, kSensorQos)), std::nullopt);
  EXPECT_EQ(mismatch(scans(kLatchedQos), reader("rt/scan", kScan, kLatchedQos)), std::nullopt);
}

TEST(Mismatch, IsNoneOfOtherTopicsAndDirections) {
  EXPECT_EQ(mismatch(commands(), writer("rt/other", kScan)), std::nullopt);
  // another node that takes or gives the same is no business of the simulation
  EXPECT_EQ(mismatch(commands(), reader("rt/cmd_vel", kScan)), std::nullopt);
  EXPECT_EQ(mismatch(scans(), writer("rt/scan", kTwist)), std::nullopt);
}

TEST(Mismatch, NamesBothTypes) {
  EXPECT_EQ(mismatch(commands(), writer("rt/cmd_vel", "std_msgs::msg::dds_::String_")),
            "a node publishes '/cmd_vel' as std_msgs/msg/String, which is geometry_msgs/msg/Twist here: nothing of it "
            "gets here");
  EXPECT_EQ(mismatch(scans(), reader("rt/scan", "Bare")),
            "a node subscribes to '/scan' as Bare, which is sensor_msgs/msg/LaserScan here: it hears nothing");
}

TEST(Mismatch, SaysHowATypeThatHasAPairIsHad) {
  EXPECT_EQ(mismatch(commands(), writer("rt/cmd_vel", "geometry_msgs::msg::dds_::TwistStamped_")),
            "a node publishes '/cmd_vel' as geometry_msgs/msg/TwistStamped, which is geometry_msgs/msg/Twist here: "
            "nothing of it gets here; --ros2-topic '/cmd_vel@geometry_msgs/msg/TwistStamped@ignition.msgs.Twist' makes "
            "it that");
}

TEST(Mismatch, NamesTheQualityThatIsMissing) {
  EXPECT_EQ(mismatch(scans(kBestEffort), reader("rt/scan", kScan)),
            "a node subscribes to '/scan' as reliable, which it is not: it hears nothing");
  EXPECT_EQ(mismatch(scans(), reader("rt/scan", kScan, kLatchedQos)),
            "a node subscribes to '/scan' as transient local, which it is not: it hears nothing");
  EXPECT_EQ(mismatch(commands(kDefaultQos), writer("rt/cmd_vel", kTwist, kBestEffort)),
            "a node publishes '/cmd_vel' as not reliable, which is asked for here: nothing of it gets here");
}

}  // namespace
}  // namespace pongsim::ros2
