#include "ros2/config/elements.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

class ElementsTest : public testing::Test {
 protected:
  /// Adds an element to the plugin, on its own line.
  void add(const std::string& name, const std::string& text) {
    plugin_.name = "plugin";
    Element& element = plugin_.children.emplace_back();
    element.name = name;
    element.text = text;
    element.position = {std::make_shared<const std::string>((folder_.path() / "world.sdf").string()),
                        static_cast<int>(plugin_.children.size()), 7};
  }

  std::optional<Settings> read() {
    SettingsElements elements;
    Declaration declaration;
    elements.declare(declaration);
    Diagnostics diagnostics;
    EXPECT_TRUE(declaration.read(plugin_, "ros2", diagnostics));
    auto settings = elements.read(plugin_, diagnostics);
    EXPECT_EQ(settings.has_value(), !diagnostics.hasErrors());
    said_.clear();
    for (const Diagnostic& each : diagnostics.all()) {
      said_ +=
          std::to_string(each.position.line) + ":" + std::to_string(each.position.column) + ": " + each.message + "\n";
    }
    return settings;
  }

  test::TempFolder folder_;
  Element plugin_;
  std::string said_;
};

TEST_F(ElementsTest, LeaveTheUsualWhereNothingIsSaid) {
  const auto settings = read();
  ASSERT_TRUE(settings.has_value());
  EXPECT_EQ(settings->nodeName, "pongsim");
  EXPECT_EQ(settings->nameSpace, "/");
  EXPECT_TRUE(settings->bridgesAll);
  EXPECT_TRUE(settings->rules.empty());
  EXPECT_FALSE(settings->frames.usesWallTime);
  EXPECT_EQ(said_, "");
}

TEST_F(ElementsTest, SayAllThatCanBeSaid) {
  add("domain", "7");
  add("distro", "jazzy");
  add("node_name", "bridge");
  add("namespace", "demo");
  add("frame_prefix", "one/");
  add("bridge_all", "false");
  add("override_timestamps_with_wall_time", "true");
  add("expand_gz_topic_names", "true");
  add("topic", "chatter@std_msgs/msg/String@gz.msgs.StringMsg");
  add("topic", "/world/w/control@ros_gz_interfaces/srv/ControlWorld");
  const auto settings = read();
  ASSERT_TRUE(settings.has_value()) << said_;
  EXPECT_EQ(settings->participant.domain, 7);
  EXPECT_EQ(settings->distro, "jazzy");
  EXPECT_EQ(settings->nodeName, "bridge");
  EXPECT_EQ(settings->nameSpace, "/demo");
  EXPECT_EQ(settings->frames.prefix, "one/");
  EXPECT_FALSE(settings->bridgesAll);
  EXPECT_TRUE(settings->frames.usesWallTime);
  ASSERT_EQ(settings->rules.size(), 1U);
  EXPECT_EQ(settings->rules[0].ros, "/demo/chatter");
  EXPECT_EQ(settings->rules[0].ignition, "/demo/chatter");
  EXPECT_EQ(settings->rules[0].position.line, 9);
  EXPECT_EQ(settings->services.size(), 1U);
}

TEST_F(ElementsTest, NameAFileFromTheFolderOfTheWorld) {
  std::filesystem::create_directory(folder_.path() / "config");
  std::ofstream(folder_.path() / "config/bridge.yaml")
      << "- {topic_name: /chatter, ros_type_name: std_msgs/msg/String, gz_type_name: gz.msgs.StringMsg}\n";
  add("config_file", "config/bridge.yaml");
  const auto settings = read();
  ASSERT_TRUE(settings.has_value()) << said_;
  EXPECT_EQ(settings->rules.size(), 1U);
  add("topic", "/chatter@std_msgs/msg/Bool@gz.msgs.Boolean");
  EXPECT_FALSE(read().has_value());
  EXPECT_NE(said_.find("2:7: ROS topic '/chatter' can't be std_msgs/msg/Bool here"), std::string::npos) << said_;
}

TEST_F(ElementsTest, RefuseADomainThatIsNone) {
  for (const char* domain : {"233", "-1", "1.5"}) {
    plugin_.children.clear();
    add("domain", domain);
    EXPECT_FALSE(read().has_value()) << domain;
    EXPECT_EQ(said_, "1:7: the ROS domain must be an integer between 0 and 232\n");
  }
}

TEST_F(ElementsTest, RefuseADomainOfTheEnvironmentThatIsNone) {
  const char* before = std::getenv("ROS_DOMAIN_ID");
  const std::optional<std::string> kept = before == nullptr ? std::nullopt : std::optional<std::string>(before);
  setenv("ROS_DOMAIN_ID", "233", 1);
  EXPECT_FALSE(read().has_value());
  EXPECT_NE(said_.find("ROS_DOMAIN_ID is '233'"), std::string::npos) << said_;
  add("domain", "5");
  EXPECT_TRUE(read().has_value()) << said_;
  kept ? setenv("ROS_DOMAIN_ID", kept->c_str(), 1) : unsetenv("ROS_DOMAIN_ID");
}

TEST_F(ElementsTest, SayAllErrorsAtOnce) {
  add("distro", "humbel");
  add("node_name", "a/b");
  add("namespace", "/9lives");
  add("topic", "nonsense");
  add("config_file", "none.yaml");
  EXPECT_FALSE(read().has_value());
  EXPECT_NE(said_.find("1:7: 'humbel' is not a ROS 2 distribution"), std::string::npos) << said_;
  EXPECT_NE(said_.find("2:7: the name of the node, 'a/b', contains a slash"), std::string::npos) << said_;
  EXPECT_NE(said_.find("3:7: the namespace '/9lives' has a word that begins with the digit 9"), std::string::npos);
  EXPECT_NE(said_.find("4:7: 'nonsense' has no topic before the '@'"), std::string::npos) << said_;
  EXPECT_NE(said_.find("0:0: the file can't be read"), std::string::npos) << said_;
}

TEST_F(ElementsTest, WarnOfWhatHasNoEffect) {
  add("bridge_all", "false");
  add("expand_gz_topic_names", "true");
  EXPECT_TRUE(read().has_value());
  EXPECT_NE(said_.find("1:7: no topic is bridged"), std::string::npos) << said_;
  EXPECT_NE(said_.find("2:7: <expand_gz_topic_names> has no effect"), std::string::npos) << said_;
}

}  // namespace
}  // namespace pongsim::ros2
