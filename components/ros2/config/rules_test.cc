#include "ros2/config/rules.hh"

#include <gtest/gtest.h>

#include <string>

#include "ros2/config/bridge_file.hh"
#include "ros2/config/topic_argument.hh"

namespace pongsim::ros2 {
namespace {

struct MadeRules {
  Rules rules;
  /// The diagnostics, one or two lines each.
  std::string said;
};

MadeRules makeOf(const std::vector<RuleText>& texts, Diagnostics& diagnostics, const NameScope& scope) {
  MadeRules made;
  made.rules = makeRules(texts, scope, diagnostics);
  for (const Diagnostic& each : diagnostics.all()) made.said += format(each) + "\n";
  return made;
}

MadeRules ofArguments(std::initializer_list<const char*> arguments, const NameScope& scope = {}) {
  Diagnostics diagnostics;
  std::vector<RuleText> texts;
  int line = 0;
  for (const char* argument : arguments) {
    texts.push_back(*readTopicArgument(argument, {std::make_shared<const std::string>("w"), ++line, 1}, diagnostics));
  }
  return makeOf(texts, diagnostics, scope);
}

MadeRules ofFile(const std::string& text, const NameScope& scope = {}) {
  Diagnostics diagnostics;
  const std::vector<RuleText> texts = readBridgeText(text, "f", diagnostics);
  return makeOf(texts, diagnostics, scope);
}

TEST(Rules, FindThePair) {
  const MadeRules made = ofArguments({"/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"});
  EXPECT_EQ(made.said, "");
  ASSERT_EQ(made.rules.topics.size(), 1U);
  const TopicRule& rule = made.rules.topics[0];
  EXPECT_EQ(rule.pair->ros, "sensor_msgs/msg/LaserScan");
  EXPECT_EQ(rule.pair->ignition, "ignition.msgs.LaserScan");
  EXPECT_EQ(rule.ros, "/scan");
  EXPECT_EQ(rule.ignition, "/scan");
  EXPECT_EQ(rule.position.line, 1);
}

TEST(Rules, TakeEachWayOfNamingAType) {
  for (const char* type : {"ignition.msgs.Clock", "gz.msgs.Clock", "ignition::msgs::Clock", "gz::msgs::Clock"}) {
    EXPECT_EQ(ofArguments({(std::string("/clock@rosgraph_msgs/msg/Clock[") + type).c_str()}).rules.topics.size(), 1U)
        << type;
  }
}

TEST(Rules, NameTheNearestType) {
  EXPECT_EQ(ofArguments({"/a@sensor_msgs/msg/LaserScam@gz.msgs.LaserScan"}).said,
            "w:1:1: error: 'sensor_msgs/msg/LaserScam' is not a ROS type that can be bridged\n"
            "  hint: did you mean 'sensor_msgs/msg/LaserScan'?\n");
  EXPECT_EQ(ofArguments({"/a@sensor_msgs/msg/LaserScan@gz.msgs.LaserScam"}).said,
            "w:1:1: error: 'gz.msgs.LaserScam' is not a message type\n"
            "  hint: did you mean 'ignition.msgs.LaserScan'?\n");
  EXPECT_EQ(ofArguments({"/a@sensor_msgs/msg/LaserScan@gz.msgs.Twist"}).said,
            "w:1:1: error: sensor_msgs/msg/LaserScan does not match ignition.msgs.Twist\n"
            "  hint: use ignition.msgs.LaserScan\n");
}

TEST(Rules, CompleteNamesWithTheNamespace) {
  const NameScope scope{.nameSpace = "/demo", .nodeName = "bridge"};
  const char* const relative = "chatter@std_msgs/msg/String@gz.msgs.StringMsg";
  TopicRule rule = ofArguments({relative}, scope).rules.topics.at(0);
  EXPECT_EQ(rule.ros, "/demo/chatter");
  EXPECT_EQ(rule.ignition, "/chatter");
  NameScope expanding = scope;
  expanding.expandsIgnition = true;
  rule = ofArguments({relative}, expanding).rules.topics.at(0);
  EXPECT_EQ(rule.ros, "/demo/chatter");
  EXPECT_EQ(rule.ignition, "/demo/chatter");
  rule = ofArguments({"~/chatter@std_msgs/msg/String@gz.msgs.StringMsg"}, expanding).rules.topics.at(0);
  EXPECT_EQ(rule.ros, "/demo/bridge/chatter");
  EXPECT_EQ(rule.ignition, "/demo/bridge/chatter");
  rule = ofArguments({"/chatter@std_msgs/msg/String@gz.msgs.StringMsg"}, expanding).rules.topics.at(0);
  EXPECT_EQ(rule.ros, "/chatter");
  EXPECT_EQ(rule.ignition, "/chatter");
}

TEST(Rules, RefuseNamesThatCanBeNone) {
  EXPECT_NE(ofArguments({"/a-b@std_msgs/msg/String@gz.msgs.StringMsg"}).said.find("topic '/a-b' has a '-'"),
            std::string::npos);
  EXPECT_NE(ofArguments({"~/a@std_msgs/msg/String@gz.msgs.StringMsg"})
                .said.find("set expand_gz_topic_names to expand it as in ROS"),
            std::string::npos);
}

TEST(Rules, RefuseATopicThatTwoTypesClaim) {
  EXPECT_EQ(
      ofArguments({"/a@geometry_msgs/msg/Twist@gz.msgs.Twist", "/a@geometry_msgs/msg/TwistStamped@gz.msgs.Twist"}).said,
      "w:2:1: error: ROS topic '/a' can't be geometry_msgs/msg/TwistStamped here and geometry_msgs/msg/Twist "
      "at w:1:1\n");
  EXPECT_EQ(ofFile("- {ros_topic_name: a, gz_topic_name: c, ros_type_name: std_msgs/msg/Bool, gz_type_name: "
                   "gz.msgs.Boolean}\n"
                   "- {ros_topic_name: b, gz_topic_name: c, ros_type_name: std_msgs/msg/Int32, gz_type_name: "
                   "gz.msgs.Int32}\n")
                .said,
            "f:2:3: error: topic '/c' of the simulation can't be ignition.msgs.Int32 here and ignition.msgs.Boolean at "
            "f:1:3\n");
}

TEST(Rules, GiveOneTopicSeveralNamesAndSeveralTopicsOne) {
  const MadeRules made = ofFile(
      "- {ros_topic_name: tf, gz_topic_name: a, ros_type_name: tf2_msgs/msg/TFMessage, gz_type_name: gz.msgs.Pose_V}\n"
      "- {ros_topic_name: tf, gz_topic_name: b, ros_type_name: tf2_msgs/msg/TFMessage, gz_type_name: gz.msgs.Pose_V}\n"
      "- {ros_topic_name: poses, gz_topic_name: a, ros_type_name: geometry_msgs/msg/PoseArray, gz_type_name: "
      "gz.msgs.Pose_V}\n");
  EXPECT_EQ(made.said, "");
  EXPECT_EQ(made.rules.topics.size(), 3U);
}

constexpr const char* kOneWay =
    "- ros_topic_name: ros_chatter\n  gz_topic_name: gz_chatter\n  ros_type_name: std_msgs/msg/String\n"
    "  gz_type_name: ignition.msgs.StringMsg\n";

TEST(Rules, JoinTheTwoWaysOfATopic) {
  const MadeRules made = ofFile(kOneWay + std::string("  subscriber_queue: 5\n  lazy: true\n  direction: ROS_TO_GZ\n") +
                                kOneWay + "  publisher_queue: 20\n  lazy: false\n  direction: GZ_TO_ROS\n");
  EXPECT_EQ(made.said, "");
  ASSERT_EQ(made.rules.topics.size(), 1U);
  const TopicRule& rule = made.rules.topics[0];
  EXPECT_EQ(rule.direction, Direction::kBoth);
  EXPECT_EQ(rule.toRos, (DirectionRule{.depth = 20, .isLazy = false}));
  EXPECT_EQ(rule.fromRos, (DirectionRule{.depth = 5, .isLazy = true}));
}

TEST(Rules, WarnOfWhatIsSaidTwiceAndRefuseWhatIsSaidInTwoWays) {
  EXPECT_EQ(ofFile(std::string(kOneWay) + kOneWay).said, "f:5:3: warning: it repeats the rule at f:1:3\n");
  EXPECT_EQ(ofFile(std::string(kOneWay) + kOneWay + "  publisher_queue: 3\n").said,
            "f:5:3: error: topic '/ros_chatter' is bridged differently at f:1:3\n");
  EXPECT_EQ(ofFile(std::string(kOneWay) + kOneWay + "  direction: GZ_TO_ROS\n").said,
            "f:5:3: error: topic '/ros_chatter' is bridged differently at f:1:3\n");
}

TEST(Rules, WarnOfWhatHasNoEffect) {
  EXPECT_EQ(ofFile(std::string(kOneWay) + "  frame_id: map\n").said,
            "f:1:3: warning: the frame_id has no effect: std_msgs/msg/String has no header\n");
  EXPECT_EQ(ofFile(std::string(kOneWay) + "  lazy: true\n  qos: {durability: transient_local}\n").said,
            "f:1:3: warning: a lazy topic can only offer late readers what came since the first one\n"
            "  hint: set lazy: false for transient_local\n");
}

TEST(Rules, KnowTheServicesOfAWorld) {
  const MadeRules made =
      ofArguments({"/world/w/control@ros_gz_interfaces/srv/ControlWorld",
                   "/world/w/create@ros_gz_interfaces/srv/SpawnEntity@gz.msgs.EntityFactory@gz.msgs.Boolean"});
  EXPECT_EQ(made.said, "");
  ASSERT_EQ(made.rules.services.size(), 2U);
  EXPECT_EQ(made.rules.services[0].ros, "/world/w/control");
  EXPECT_EQ(made.rules.services[0].ignition, "/world/w/control");
  EXPECT_EQ(made.rules.services[1].type, "ros_gz_interfaces/srv/SpawnEntity");
}

TEST(Rules, WarnOfServicesOfAnotherWorld) {
  const MadeRules made = ofArguments(
      {"/world/w/control@ros_gz_interfaces/srv/ControlWorld", "/world/v/create@ros_gz_interfaces/srv/SpawnEntity"});
  Diagnostics diagnostics;
  warnOfOtherWorlds(made.rules.services, "w", diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(format(diagnostics.all()[0]),
            "w:2:1: warning: service '/world/v/create' belongs to another world and is not bridged\n"
            "  hint: this world is 'w'");
}

TEST(Rules, TakeTheWordsOfHumble) {
  const MadeRules made = ofFile(
      "- {ros_topic_name: a, ign_topic_name: b, ros_type_name: std_msgs/msg/String, ign_type_name: "
      "ignition.msgs.StringMsg, direction: ROS_TO_IGN, subscriber_queue: 5}\n"
      "- {ros_topic_name: a, ign_topic_name: b, ros_type_name: std_msgs/msg/String, ign_type_name: "
      "ignition.msgs.StringMsg, direction: IGN_TO_ROS, publisher_queue: 20}\n");
  EXPECT_EQ(made.said, "");
  ASSERT_EQ(made.rules.topics.size(), 1U);
  EXPECT_EQ(made.rules.topics[0].direction, Direction::kBoth);
}

TEST(Rules, RefuseServicesThatAreNone) {
  EXPECT_EQ(ofArguments({"/world/w/control@ros_gz_interfaces/srv/ControlWord"}).said,
            "w:1:1: error: 'ros_gz_interfaces/srv/ControlWord' is not a service that can be bridged\n"
            "  hint: did you mean 'ros_gz_interfaces/srv/ControlWorld'?\n");
  EXPECT_NE(ofArguments({"/pause@ros_gz_interfaces/srv/ControlWorld"}).said.find("hint: it is '/world/WORLD/control'"),
            std::string::npos);
  EXPECT_NE(ofArguments({"/world/w/control@ros_gz_interfaces/srv/ControlWorld@gz.msgs.Pose@gz.msgs.Boolean"})
                .said.find("does not match gz.msgs.Pose"),
            std::string::npos);
  EXPECT_NE(ofFile("- {ros_service_name: a, gz_service_name: /world/v/control, ros_type_name: "
                   "ros_gz_interfaces/srv/ControlWorld}\n"
                   "- {ros_service_name: a, gz_service_name: /world/w/control, ros_type_name: "
                   "ros_gz_interfaces/srv/ControlWorld}\n")
                .said.find("f:2:3: error: ROS service '/a' is '/world/v/control' at f:1:3"),
            std::string::npos);
}

}  // namespace
}  // namespace pongsim::ros2
