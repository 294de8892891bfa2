#include "ros2/bridge/bridge.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ros2/pairs/pairs.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using ignition::msgs::StringMsg;

StringMsg textOf(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

/// Texts received on DDS's threads.
class Heard {
 public:
  void add(const std::string& text) {
    const std::lock_guard lock(mutex_);
    texts_.push_back(text);
  }
  std::vector<std::string> all() const {
    const std::lock_guard lock(mutex_);
    return texts_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
};

/// A bridge on a transport without a world, and another ROS node.
class BridgeTest : public testing::Test {
 protected:
  Bridge& bridge(const Settings& settings = {}) {
    bridge_.emplace(simulation_, ros_, settings);
    bridge_->update();
    return *bridge_;
  }

  bool updateUntil(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + test::kDeadline;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      bridge_->update();
      transport_.dispatchFor(std::chrono::milliseconds(2));
    }
    return true;
  }

  std::unique_ptr<RosSubscription> hear(const std::string& topic, Heard& heard, const Qos& qos = kDefaultQos) {
    return peer_.subscribe<std_msgs::String>(
        topic, [&heard](const std_msgs::String& message) { heard.add(message.data); }, qos);
  }

  const int domain_ = test::testDomain();
  Transport transport_{{.network = false}};
  Node simulation_ = transport_.node();
  Participant participant_{{.domain = domain_}};
  RosNode ros_{participant_, {}};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
  std::optional<Bridge> bridge_;
};

TEST_F(BridgeTest, ListensInTheSimulationForAsLongAsANodeListens) {
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  bridge();
  EXPECT_FALSE(publisher.hasSubscribers());
  Heard heard;
  {
    const auto reader = hear("/chatter", heard);
    EXPECT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
    publisher.publish(textOf("hello"));
    EXPECT_TRUE(updateUntil([&] { return heard.all() == std::vector<std::string>{"hello"}; }));
  }
  EXPECT_TRUE(updateUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(BridgeTest, TellsTheVariancesOfASensorThatComesLater) {
  Settings settings;
  TopicRule& rule = settings.rules.emplace_back();
  rule.ignition = rule.ros = "/imu";
  rule.pair = findPair("sensor_msgs/msg/Imu", "ignition.msgs.IMU");
  rule.direction = Direction::kToRos;
  NoiseVariances variances;
  bridge(settings).useVariances([&variances] { return variances; });
  std::atomic<double> heard = -1;
  const auto reader = peer_.subscribe<sensor_msgs::Imu>(
      "/imu", [&heard](const sensor_msgs::Imu& imu) { heard = imu.angular_velocity_covariance[0]; });
  const auto hears = [&](Publisher& publisher, double variance) {
    return updateUntil([&] {
      publisher.publish(ignition::msgs::IMU());
      return heard == variance;
    });
  };
  {
    Publisher other = simulation_.advertise<ignition::msgs::IMU>("/imu");
    EXPECT_TRUE(hears(other, 0));
  }
  variances["/imu"].reading = {4, 4, 4};
  Publisher publisher = simulation_.advertise<ignition::msgs::IMU>("/imu");
  EXPECT_TRUE(hears(publisher, 4));
}

TEST_F(BridgeTest, CarriesEachWayAndNothingBack) {
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  std::vector<std::string> inside;
  const Subscription subscription =
      simulation_.subscribe<StringMsg>("/chatter", [&](const StringMsg& message) { inside.push_back(message.data()); });
  bridge();
  Heard outside;
  const auto reader = hear("/chatter", outside);
  const auto writer = peer_.advertise<std_msgs::String>("/chatter");
  const auto bridged = [&] {
    const auto topics = bridge_->topics();
    return topics.size() == 1 && topics[0].readers == 1 && topics[0].writers == 1 && writer->hasReaders();
  };
  // the peer's own reader belongs to its own participant, from which it receives nothing
  ASSERT_TRUE(updateUntil(bridged));
  writer->publish(std_msgs::String{"from ROS"});
  ASSERT_TRUE(updateUntil([&] { return inside.size() == 1; }));
  publisher.publish(textOf("to ROS"));
  ASSERT_TRUE(updateUntil([&] { return !outside.all().empty(); }));
  EXPECT_EQ(outside.all(), std::vector<std::string>{"to ROS"});
  transport_.dispatch();
  EXPECT_EQ(inside, (std::vector<std::string>{"from ROS", "to ROS"}));
}

TEST_F(BridgeTest, FollowsTopicsThatComeAndGo) {
  bridge();
  EXPECT_TRUE(bridge_->topics().empty());
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  bridge_->update();
  ASSERT_EQ(bridge_->topics().size(), 1U);
  EXPECT_TRUE(bridge_->topics()[0].isToRos);
  EXPECT_FALSE(bridge_->topics()[0].isFromRos);
  publisher = {};
  bridge_->update();
  EXPECT_FALSE(bridge_->topics()[0].isToRos);
}

TEST_F(BridgeTest, GivesWhatIsLatchedToWhoComesLater) {
  Publisher publisher = simulation_.advertise<StringMsg>("/description", {.latched = true});
  publisher.publish(textOf("robot"));
  bridge();
  ASSERT_TRUE(updateUntil([&] { return bridge_->topics()[0].sent == 1; }));
  Heard heard;
  const auto reader = hear("/description", heard, kLatchedQos);
  EXPECT_TRUE(updateUntil([&] { return heard.all() == std::vector<std::string>{"robot"}; }));
}

TEST_F(BridgeTest, RefusesACommandThatIsNoNumber) {
  int commands = 0;
  const Subscription subscription =
      simulation_.subscribe<ignition::msgs::Twist>("/cmd_vel", [&](const ignition::msgs::Twist&) { ++commands; });
  bridge();
  const auto writer = peer_.advertise<geometry_msgs::Twist>("/cmd_vel");
  // both have discovered each other, which happens one after the other
  ASSERT_TRUE(updateUntil([&] { return writer->hasReaders() && bridge_->topics()[0].writers == 1; }));
  geometry_msgs::Twist twist;
  twist.angular.z = std::numeric_limits<double>::quiet_NaN();
  writer->publish(twist);
  twist.angular.z = 1;
  writer->publish(twist);
  ASSERT_TRUE(updateUntil([&] { return commands == 1; }));
  EXPECT_EQ(bridge_->topics()[0].refused, 1U);
  EXPECT_EQ(ros_.malformed(), 1U);
}

TEST_F(BridgeTest, WritesThePixelsOfAPictureOnceForAllReaders) {
  Publisher publisher = simulation_.advertise<ignition::msgs::Image>("/camera");
  bridge();
  std::atomic<int> got = 0;
  const auto count = [&](const sensor_msgs::Image& image) { got += image.data.size() == 12 ? 1 : 0; };
  std::vector<std::unique_ptr<RosSubscription>> readers;
  for (int i = 0; i < 3; ++i) readers.push_back(peer_.subscribe<sensor_msgs::Image>("/camera", count, kDefaultQos));
  ASSERT_TRUE(updateUntil([&] { return bridge_->topics()[0].readers == 3 && publisher.hasSubscribers(); }));
  ignition::msgs::Image image;
  image.set_width(2);
  image.set_height(2);
  image.set_pixel_format_type(ignition::msgs::RGB_INT8);
  int written = 0;
  publisher.publish(image, {.size = 12, .write = [&](std::span<std::byte> place) {
                              ++written;
                              std::ranges::fill(place, std::byte(1));
                            }});
  EXPECT_TRUE(updateUntil([&] { return got == 3; }));
  EXPECT_EQ(written, 1);
}

/// Settings that bridge only "/chatter", as "/talk" in ROS.
Settings onlyChatter(Direction direction) {
  Settings settings;
  settings.bridgesAll = false;
  TopicRule& rule = settings.rules.emplace_back();
  rule.ros = "/talk";
  rule.ignition = "/chatter";
  rule.pair = findPair("std_msgs/msg/String", "ignition.msgs.StringMsg");
  rule.direction = direction;
  return settings;
}

TEST_F(BridgeTest, FollowsARule) {
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter"),
            other = simulation_.advertise<StringMsg>("/other");
  bridge(onlyChatter(Direction::kToRos));
  ASSERT_EQ(bridge_->topics().size(), 1U);
  Heard heard;
  const auto reader = hear("/talk", heard);
  ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
  publisher.publish(textOf("hello"));
  EXPECT_TRUE(updateUntil([&] { return heard.all() == std::vector<std::string>{"hello"}; }));
}

TEST_F(BridgeTest, ListensFromTheStartWhereARuleIsNotLazy) {
  const Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  Settings settings = onlyChatter(Direction::kToRos);
  bridge(settings);
  EXPECT_FALSE(publisher.hasSubscribers());
  settings.rules[0].toRos.isLazy = false;
  bridge(settings);
  EXPECT_TRUE(publisher.hasSubscribers());
}

TEST_F(BridgeTest, KeepsForLateNodesWhatARuleSays) {
  Settings settings = onlyChatter(Direction::kToRos);
  settings.rules[0].toRos = {.depth = 2, .isTransientLocal = true};
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  bridge(settings);
  for (const char* text : {"one", "two", "three"}) publisher.publish(textOf(text));
  ASSERT_TRUE(updateUntil([&] { return bridge_->topics()[0].sent == 3; }));
  Heard heard;
  const auto reader = hear("/talk", heard, {.isTransientLocal = true, .depth = 10});
  EXPECT_TRUE(updateUntil([&] { return heard.all() == std::vector<std::string>{"two", "three"}; }));
}

TEST_F(BridgeTest, ReadsLazilyWhileSomebodyListensInTheSimulation) {
  Settings settings = onlyChatter(Direction::kFromRos);
  settings.rules[0].fromRos.isLazy = true;
  bridge(settings);
  const auto writer = peer_.advertise<std_msgs::String>("/talk");
  std::vector<std::string> inside;
  {
    const Subscription subscription = simulation_.subscribe<StringMsg>(
        "/chatter", [&](const StringMsg& message) { inside.push_back(message.data()); });
    ASSERT_TRUE(updateUntil([&] { return writer->hasReaders() && bridge_->topics()[0].writers == 1; }));
    writer->publish(std_msgs::String{"heard"});
    EXPECT_TRUE(updateUntil([&] { return inside == std::vector<std::string>{"heard"}; }));
  }
  EXPECT_TRUE(updateUntil([&] { return !writer->hasReaders(); }));
}

TEST_F(BridgeTest, PutsAFrameOfARuleIntoHeaders) {
  Settings settings;
  TopicRule& rule = settings.rules.emplace_back();
  rule.ros = "/points";
  rule.ignition = "/camera";
  rule.pair = findPair("sensor_msgs/msg/Image", "ignition.msgs.Image");
  rule.frameId = "optical";
  settings.frames.prefix = "one/";
  Publisher publisher = simulation_.advertise<ignition::msgs::Image>("/camera");
  bridge(settings);
  Heard frames;
  const auto reader = peer_.subscribe<sensor_msgs::Image>(
      "/points", [&](const sensor_msgs::Image& image) { frames.add(image.header.frame_id); }, kDefaultQos);
  ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
  publisher.publish(ignition::msgs::Image());
  EXPECT_TRUE(updateUntil([&] { return frames.all() == std::vector<std::string>{"optical"}; }));
}

TEST_F(BridgeTest, SaysThatARuleIsForAnotherType) {
  const Publisher publisher = simulation_.advertise<ignition::msgs::Twist>("/chatter");
  Settings settings = onlyChatter(Direction::kToRos);
  settings.rules[0].position = {std::make_shared<const std::string>("bridge.yaml"), 4, 3};
  testing::internal::CaptureStderr();
  bridge(settings).update();
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: ros2: bridge.yaml:4:3: topic '/chatter' of the simulation has type ignition.msgs.Twist, but the "
            "configuration bridges it as ignition.msgs.StringMsg\n");
}

TEST_F(BridgeTest, BridgesNoTopicUnderANameThatARuleGivesToAnother) {
  const Publisher publisher = simulation_.advertise<StringMsg>("/talk"),
                  other = simulation_.advertise<StringMsg>("/other");
  Settings settings = onlyChatter(Direction::kToRos);
  settings.bridgesAll = true;
  bridge(settings);
  std::vector<std::string> names;
  for (const Bridge::Topic& topic : bridge_->topics()) names.push_back(topic.ignition);
  EXPECT_EQ(names, (std::vector<std::string>{"/chatter", "/other"}));
}

TEST_F(BridgeTest, LeavesOutWhatAnotherServes) {
  Publisher publisher = simulation_.advertise<StringMsg>("/taken");
  bridge_.emplace(simulation_, ros_, Settings());
  bridge_->reserve("/taken");
  bridge_->update();
  EXPECT_TRUE(bridge_->topics().empty());
}

TEST_F(BridgeTest, WhetherAllTopicsAreBridgedMayChange) {
  Publisher publisher = simulation_.advertise<StringMsg>("/chatter");
  bridge();
  Heard heard;
  const auto reader = hear("/chatter", heard);
  ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
  bridge_->setBridgesAll(false);
  bridge_->update();
  EXPECT_FALSE(bridge_->topics().at(0).isToRos);
  EXPECT_FALSE(publisher.hasSubscribers());
  bridge_->setBridgesAll(true);
  ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
  publisher.publish(textOf("again"));
  EXPECT_TRUE(updateUntil([&] { return heard.all() == std::vector<std::string>{"again"}; }));
}

TEST_F(BridgeTest, WhetherStampsAreWallTimeMayChange) {
  Publisher publisher = simulation_.advertise<ignition::msgs::Image>("/picture");
  bridge();
  std::atomic<int> second = -1;
  const auto reader = peer_.subscribe<sensor_msgs::Image>(
      "/picture", [&](const sensor_msgs::Image& image) { second = image.header.stamp.sec; }, kDefaultQos);
  ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
  ignition::msgs::Image image;
  image.mutable_header()->mutable_stamp()->set_sec(5);
  for (const bool isWallTime : {true, false}) {
    bridge_->setWallTime(isWallTime);
    ASSERT_TRUE(updateUntil([&] { return publisher.hasSubscribers(); }));
    publisher.publish(image);
    EXPECT_TRUE(updateUntil([&] { return isWallTime ? second > 1'600'000'000 : second == 5; }));
  }
}

}  // namespace
}  // namespace pongsim::ros2
