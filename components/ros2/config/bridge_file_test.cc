#include "ros2/config/bridge_file.hh"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

struct FileRead {
  std::vector<RuleText> rules;
  std::vector<Diagnostic> said;
};

FileRead fileOf(const std::string& text) {
  Diagnostics diagnostics;
  FileRead result;
  result.rules = readBridgeText(text, "bridge.yaml", diagnostics);
  result.said = diagnostics.all();
  return result;
}

/// A topic with additional keys.
std::string topicWith(const std::string& keys) {
  return "- topic_name: a\n  ros_type_name: std_msgs/msg/String\n  gz_type_name: gz.msgs.StringMsg\n" + keys;
}

/// @return The diagnostics of the text, one per line.
std::string saidOf(const std::string& text) {
  std::string said;
  for (const Diagnostic& each : fileOf(text).said) said += format(each) + "\n";
  return said;
}

TEST(BridgeFile, TakesAllKeysOfATopic) {
  const FileRead result = fileOf(R"(# comment
- ros_topic_name: "ros_chatter"
  gz_topic_name: gz_chatter
  ros_type_name: "std_msgs/msg/String"
  gz_type_name: "ignition.msgs.StringMsg"
  subscriber_queue: 5
  publisher_queue: 6
  lazy: true
  direction: ROS_TO_GZ
  frame_id: map
  frame_prefix: one/
  qos: {reliability: best_effort, durability: transient_local}
)");
  ASSERT_TRUE(result.said.empty()) << result.said[0].message;
  ASSERT_EQ(result.rules.size(), 1U);
  const RuleText& rule = result.rules[0];
  EXPECT_EQ(rule.ros->text, "ros_chatter");
  EXPECT_EQ(rule.ros->position.line, 2);
  EXPECT_EQ(rule.ros->position.column, 19);
  EXPECT_EQ(rule.ignition->text, "gz_chatter");
  EXPECT_EQ(rule.rosType->text, "std_msgs/msg/String");
  EXPECT_EQ(rule.ignitionType->text, "ignition.msgs.StringMsg");
  EXPECT_EQ(rule.direction, Direction::kFromRos);
  EXPECT_EQ(rule.toRos, (DirectionRule{.depth = 6, .isLazy = true, .isReliable = false, .isTransientLocal = true}));
  EXPECT_EQ(rule.fromRos, (DirectionRule{.depth = 5, .isLazy = true, .isReliable = false, .isTransientLocal = true}));
  EXPECT_EQ(rule.frameId->text, "map");
  EXPECT_EQ(rule.framePrefix->text, "one/");
}

TEST(BridgeFile, GivesAMissingNameThatOfTheOtherSide) {
  for (const char* key : {"topic_name", "ros_topic_name", "gz_topic_name", "ign_topic_name"}) {
    const FileRead result =
        fileOf(std::string("- ") + key +
               ": chatter\n  ros_type_name: std_msgs/msg/String\n  ign_type_name: ignition.msgs.StringMsg\n");
    ASSERT_EQ(result.rules.size(), 1U) << key;
    EXPECT_EQ(result.rules[0].ros->text, "chatter");
    EXPECT_EQ(result.rules[0].ignition->text, "chatter");
  }
}

TEST(BridgeFile, TakesAProfileOfWhichSingleSettingsMayDiffer) {
  const DirectionRule sensor{.depth = 5, .isReliable = false, .isTransientLocal = false};
  EXPECT_EQ(fileOf(topicWith("  qos_profile: SENSOR_DATA\n")).rules.at(0).toRos, sensor);
  DirectionRule deeper = sensor;
  deeper.depth = 7;
  const RuleText rule = fileOf(topicWith("  qos_profile: SENSOR_DATA\n  publisher_queue: 7\n")).rules.at(0);
  EXPECT_EQ(rule.toRos, deeper);
  EXPECT_EQ(rule.fromRos, sensor);
}

TEST(BridgeFile, TakesServicesOfLaterVersions) {
  const FileRead result = fileOf(
      "- service_name: /world/w/control\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld\n"
      "  gz_req_type_name: gz.msgs.WorldControl\n  gz_rep_type_name: gz.msgs.Boolean\n"
      "- ros_service_name: /spawn\n  gz_service_name: /world/w/create\n"
      "  ros_type_name: ros_gz_interfaces/srv/SpawnEntity\n");
  ASSERT_TRUE(result.said.empty()) << result.said[0].message;
  ASSERT_EQ(result.rules.size(), 2U);
  EXPECT_TRUE(result.rules[0].isService);
  EXPECT_EQ(result.rules[0].requestType->text, "gz.msgs.WorldControl");
  EXPECT_EQ(result.rules[1].ros->text, "/spawn");
  EXPECT_EQ(result.rules[1].ignition->text, "/world/w/create");
}

TEST(BridgeFile, WarnsOfAKeyThatItDoesNotKnow) {
  EXPECT_EQ(saidOf(topicWith("  direcion: GZ_TO_ROS\n")),
            "bridge.yaml:4:3: warning: key 'direcion' is unknown and has no effect\n"
            "  hint: did you mean 'direction'?\n");
}

TEST(BridgeFile, SaysWhereItContradictsItself) {
  EXPECT_EQ(saidOf(topicWith("  ros_topic_name: b\n")),
            "bridge.yaml:4:19: error: 'topic_name' and 'ros_topic_name' can't be used together\n");
  EXPECT_EQ(saidOf(topicWith("  lazy: true\n  lazy: false\n")), "bridge.yaml:5:3: error: key 'lazy' is given twice\n");
  EXPECT_EQ(saidOf(topicWith("  ign_type_name: ignition.msgs.Int32\n")),
            "bridge.yaml:4:18: error: 'ign_type_name' is 'ignition.msgs.Int32', and 'gz.msgs.StringMsg' by its other "
            "name\n");
  EXPECT_EQ(saidOf(topicWith("  publisher_queue: 3\n  qos: {depth: 4}\n")),
            "bridge.yaml:5:16: error: the depth is 4, and 3 by 'publisher_queue'\n");
  EXPECT_EQ(saidOf("- service_name: /world/w/control\n  ros_type_name: a/srv/B\n  direction: GZ_TO_ROS\n"),
            "bridge.yaml:3:14: error: a service has no topic, direction or frame\n");
}

TEST(BridgeFile, SaysWhichValueCannotBe) {
  EXPECT_EQ(saidOf(topicWith("  direction: GZ_TO_RO\n")),
            "bridge.yaml:4:14: error: 'direction' can't be 'GZ_TO_RO'\n  hint: did you mean 'GZ_TO_ROS'?\n");
  EXPECT_EQ(saidOf(topicWith("  publisher_queue: many\n")),
            "bridge.yaml:4:20: error: 'publisher_queue' must be an integer between 1 and 1000000, not 'many'\n");
  EXPECT_EQ(saidOf(topicWith("  publisher_queue: -1\n")),
            "bridge.yaml:4:20: error: 'publisher_queue' must be an integer between 1 and 1000000, not '-1'\n");
  EXPECT_EQ(saidOf(topicWith("  lazy: perhaps\n")), "bridge.yaml:4:9: error: 'lazy' must be true or false\n");
  EXPECT_EQ(saidOf(topicWith("  qos_profile: SENSOR\n")),
            "bridge.yaml:4:16: error: 'SENSOR' is not a profile\n  hint: SENSOR_DATA, for example\n");
  EXPECT_EQ(saidOf(topicWith("  qos: {reliability: reliabel}\n")),
            "bridge.yaml:4:22: error: 'reliability' can't be 'reliabel'\n  hint: did you mean 'reliable'?\n");
  EXPECT_EQ(saidOf(topicWith("  frame_id: [a]\n")), "bridge.yaml:4:13: error: 'frame_id' must be a string\n");
}

TEST(BridgeFile, SaysWhatIsMissing) {
  EXPECT_EQ(saidOf("- ros_type_name: a\n  gz_type_name: b\n"),
            "bridge.yaml:1:3: error: no topic name is given\n"
            "  hint: topic_name: NAME, or ros_topic_name and gz_topic_name\n");
  EXPECT_EQ(saidOf("- topic_name: a\n  gz_type_name: b\n"),
            "bridge.yaml:1:3: error: there is no 'ros_type_name'\n  hint: ros_type_name: std_msgs/msg/String\n");
  EXPECT_EQ(saidOf("- topic_name: a\n  ros_type_name: b\n"),
            "bridge.yaml:1:3: error: there is no 'gz_type_name'\n  hint: gz_type_name: ignition.msgs.StringMsg\n");
}

TEST(BridgeFile, SaysWhatIsNoList) {
  EXPECT_NE(saidOf("").find("bridge.yaml: error: the file is empty"), std::string::npos);
  EXPECT_NE(saidOf("# nothing but this\n").find("bridge.yaml: error: the file is empty"), std::string::npos);
  EXPECT_NE(saidOf("topic_name: a\n").find("bridge.yaml:1:1: error: it is not a list"), std::string::npos);
  EXPECT_NE(saidOf("- a\n- topic_name\n").find("bridge.yaml:2:3: error: an item of the list must be a map"),
            std::string::npos);
  EXPECT_NE(saidOf("- topic_name: [a\n").find("bridge.yaml:2:1: error: it is not YAML: "), std::string::npos);
  EXPECT_NE(saidOf("--- []\n--- []\n").find("bridge.yaml:2:1: error: the indentation here is wrong"),
            std::string::npos);
  // yaml-cpp ignores it silently
  EXPECT_NE(saidOf("- a: b\n, c: d\n").find("bridge.yaml:2:1: error: the indentation here is wrong"),
            std::string::npos);
}

TEST(BridgeFile, GoesOnAfterAnItemThatIsWrong) {
  const FileRead result = fileOf("- topic_name: a\n" + topicWith("") + "- 3\n" + topicWith(""));
  EXPECT_EQ(result.rules.size(), 2U);
  EXPECT_EQ(result.said.size(), 2U);
}

TEST(BridgeFile, SurvivesWhatIsNoConfiguration) {
  fileOf(std::string(100'000, '['));
  fileOf(std::string(100'000, '{'));
  fileOf("- &a [*a]\n");
  fileOf("- {&a topic_name: *a}\n");
  fileOf(std::string("\0\xff\xfe- a: b", 9));
  fileOf("? [a]\n: b\n");
  fileOf("- ? {a: b}\n  : c\n");
}

TEST(BridgeFile, SurvivesAnyDamage) {
  const std::string whole = topicWith(
      "  direction: GZ_TO_ROS\n  publisher_queue: 3\n  lazy: true\n  qos: {reliability: reliable, depth: 3}\n"
      "- service_name: /world/w/control\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld\n");
  std::mt19937 random(1);
  const auto any = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(random); };
  const std::string letters = "-:{}[]&*!|>'\"%@`# \n\t,?~<a0\\\xff\0";
  for (int i = 0; i < 1000; ++i) {
    std::string text = whole;
    for (std::size_t n = 0; n <= any(5); ++n) {
      const std::size_t at = any(text.size() - 1);
      switch (any(2)) {
        case 0:
          text[at] = letters[any(letters.size() - 1)];
          break;
        case 1:
          text.erase(at, any(20));
          break;
        default:
          text.insert(at, 1, letters[any(letters.size() - 1)]);
      }
      if (text.empty()) break;
    }
    for (const Diagnostic& each : fileOf(text).said) EXPECT_FALSE(each.message.empty());
  }
}

TEST(BridgeFile, IsReadFromADisk) {
  const test::TempFolder folder;
  const auto file = folder.path() / "bridge.yaml";
  std::ofstream(file) << topicWith("");
  Diagnostics diagnostics;
  EXPECT_EQ(readBridgeFile(file, diagnostics).size(), 1U);
  EXPECT_TRUE(diagnostics.all().empty());
  readBridgeFile(folder.path() / "none.yaml", diagnostics);
  readBridgeFile(folder.path(), diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 2U);
  EXPECT_EQ(diagnostics.all()[0].message, "the file can't be read");
  EXPECT_EQ(diagnostics.all()[1].message, "it is a folder, not a file");
}

}  // namespace
}  // namespace pongsim::ros2
