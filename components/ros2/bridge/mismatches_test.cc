#include "ros2/bridge/mismatches.hh"

#include <gtest/gtest.h>

#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {
namespace {

constexpr Qos kBestEffortQos{.isReliable = false};

Offer commandOffer(const Qos& reader = kAnyWriterQos) {
  return {"/cmd_vel", "/cmd_vel", findPair("geometry_msgs/msg/Twist", "ignition.msgs.Twist"), std::nullopt, reader};
}
Offer scanOffer(const Qos& writer = kDefaultQos) {
  return {"/scan", "/lidar", findPair("sensor_msgs/msg/LaserScan", "ignition.msgs.LaserScan"), writer, std::nullopt};
}
Graph::Endpoint theirWriter(const char* topic, const char* type, const Qos& qos = kDefaultQos) {
  return {{}, Graph::Role::kWriter, {.topic = topic, .type = type, .typeHash = "", .qos = qos}};
}
Graph::Endpoint theirReader(const char* topic, const char* type, const Qos& qos = kDefaultQos) {
  return {{}, Graph::Role::kReader, {.topic = topic, .type = type, .typeHash = "", .qos = qos}};
}
constexpr const char* kTwistOnWire = "geometry_msgs::msg::dds_::Twist_";
constexpr const char* kScanOnWire = "sensor_msgs::msg::dds_::LaserScan_";

TEST(Mismatch, IsNoneWhereTheyMeet) {
  EXPECT_EQ(mismatch(commandOffer(), theirWriter("rt/cmd_vel", kTwistOnWire)), std::nullopt);
  EXPECT_EQ(mismatch(commandOffer(), theirWriter("rt/cmd_vel", kTwistOnWire, kBestEffortQos)), std::nullopt);
  EXPECT_EQ(mismatch(scanOffer(), theirReader("rt/scan", kScanOnWire)), std::nullopt);
  EXPECT_EQ(mismatch(scanOffer(kBestEffortQos), theirReader("rt/scan", kScanOnWire, kSensorQos)), std::nullopt);
  EXPECT_EQ(mismatch(scanOffer(kLatchedQos), theirReader("rt/scan", kScanOnWire, kLatchedQos)), std::nullopt);
}

TEST(Mismatch, IsNoneOfOtherTopicsAndDirections) {
  EXPECT_EQ(mismatch(commandOffer(), theirWriter("rt/other", kScanOnWire)), std::nullopt);
  // mismatches between other nodes are not reported
  EXPECT_EQ(mismatch(commandOffer(), theirReader("rt/cmd_vel", kScanOnWire)), std::nullopt);
  EXPECT_EQ(mismatch(scanOffer(), theirWriter("rt/scan", kTwistOnWire)), std::nullopt);
}

TEST(Mismatch, NamesBothTypes) {
  EXPECT_EQ(
      mismatch(commandOffer(), theirWriter("rt/cmd_vel", "std_msgs::msg::dds_::String_")),
      "a node publishes '/cmd_vel' as std_msgs/msg/String, which is geometry_msgs/msg/Twist here: no messages arrive");
  EXPECT_EQ(mismatch(scanOffer(), theirReader("rt/scan", "Bare")),
            "a node subscribes to '/scan' as Bare, which is sensor_msgs/msg/LaserScan here: it receives no messages");
}

TEST(Mismatch, SaysHowATypeThatHasAPairIsHad) {
  EXPECT_EQ(mismatch(commandOffer(), theirWriter("rt/cmd_vel", "geometry_msgs::msg::dds_::TwistStamped_")),
            "a node publishes '/cmd_vel' as geometry_msgs/msg/TwistStamped, which is geometry_msgs/msg/Twist here: "
            "no messages arrive; --ros2-topic '/cmd_vel@geometry_msgs/msg/TwistStamped@ignition.msgs.Twist' bridges "
            "that type");
}

TEST(Mismatch, NamesTheQualityThatIsMissing) {
  EXPECT_EQ(mismatch(scanOffer(kBestEffortQos), theirReader("rt/scan", kScanOnWire)),
            "a node subscribes to '/scan' as reliable, but it is published as not reliable: it receives no messages");
  EXPECT_EQ(mismatch(scanOffer(), theirReader("rt/scan", kScanOnWire, kLatchedQos)),
            "a node subscribes to '/scan' as transient local, but it is published as not transient local: it receives "
            "no messages");
  EXPECT_EQ(mismatch(commandOffer(kDefaultQos), theirWriter("rt/cmd_vel", kTwistOnWire, kBestEffortQos)),
            "a node publishes '/cmd_vel' as not reliable, but reliable is required here: no messages arrive");
}

TEST(Mismatch, NamesThePromiseThatAReaderWants) {
  Graph::Endpoint theirs = theirReader("rt/scan", kScanOnWire);
  theirs.contract.hasLiveliness = true;
  EXPECT_EQ(mismatch(scanOffer(), theirs),
            "a node subscribes to '/scan' with a liveliness, but it is published without: it receives no messages");
  theirs.contract.hasDeadline = true;
  EXPECT_EQ(mismatch(scanOffer(), theirs),
            "a node subscribes to '/scan' with a deadline, but it is published without: it receives no messages");
  // writers may promise more than is asked for
  Graph::Endpoint writer = theirWriter("rt/cmd_vel", kTwistOnWire);
  writer.contract.hasDeadline = true;
  EXPECT_EQ(mismatch(commandOffer(), writer), std::nullopt);
}

}  // namespace
}  // namespace pongsim::ros2
