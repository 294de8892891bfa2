#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ros2/command/command.hh"
#include "shared/program/console.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

class CheckTest : public testing::Test {
 protected:
  int check(const std::string& configuration, std::vector<std::string> options = {}) {
    std::ofstream(file_) << configuration;
    std::vector<std::string> words{"pongsim-ros2", "check", file_};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    constexpr cli::AddCommand kActions[] = {addCheckAction};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = cli::run(static_cast<int>(argv.size()), argv.data(), {.commands = kActions});
    printed_ = testing::internal::GetCapturedStdout();
    said_ = testing::internal::GetCapturedStderr();
    return code;
  }

  test::TempFolder folder_;
  const std::string file_ = (folder_.path() / "bridge.yaml").string();
  std::string printed_;
  std::string said_;
};

constexpr const char* kScanPair =
    "- {ros_topic_name: scan, gz_topic_name: /lidar, ros_type_name: sensor_msgs/msg/LaserScan,\n"
    "   gz_type_name: gz.msgs.LaserScan, direction: GZ_TO_ROS, qos_profile: SENSOR_DATA, frame_id: laser}\n";

TEST_F(CheckTest, SaysWhatAConfigurationDoes) {
  EXPECT_EQ(check(kScanPair, {"--namespace", "/robot"}), cli::kDone);
  EXPECT_EQ(printed_,
            "/robot/scan [sensor_msgs/msg/LaserScan]  <-  /lidar [ignition.msgs.LaserScan]  "
            "to ROS: best_effort, volatile, depth 5, lazy; frame laser\n");
  EXPECT_EQ(said_, "");
}

TEST_F(CheckTest, SaysWhatIsWrongWithTheLine) {
  EXPECT_EQ(check(std::string(kScanPair) + "- topic_name: /a\n  ros_type_name: std_msgs/msg/Strin\n"
                                           "  gz_type_name: gz.msgs.StringMsg\n"),
            cli::kFailed);
  EXPECT_EQ(said_, file_ +
                       ":4:18: error: 'std_msgs/msg/Strin' is not a ROS type that can be bridged\n"
                       "      ros_type_name: std_msgs/msg/Strin\n"
                       "                     ^\n"
                       "  hint: did you mean 'std_msgs/msg/String'?\n");
  EXPECT_NE(printed_.find("/scan"), std::string::npos);
}

TEST_F(CheckTest, PrintsJson) {
  EXPECT_EQ(check(std::string(kScanPair) + "- topic_name: /a\n", {"--json"}), cli::kFailed);
  const auto json = nlohmann::json::parse(printed_);
  EXPECT_EQ(json.at("topics").at(0).at("ros"), "/scan");
  EXPECT_EQ(json.at("topics").at(0).at("to_ros").at("reliability"), "best_effort");
  EXPECT_EQ(json.at("topics").at(0).at("to_ros").at("depth"), 5);
  EXPECT_FALSE(json.at("topics").at(0).contains("from_ros"));
  EXPECT_EQ(json.at("diagnostics").at(0).at("line"), 3);
  EXPECT_EQ(json.at("diagnostics").at(0).at("severity"), "error");
}

TEST_F(CheckTest, FailsWhereTheFileIsNotThere) {
  constexpr cli::AddCommand kActions[] = {addCheckAction};
  std::string words[] = {"pongsim-ros2", "check", folder_.path() / "none.yaml"};
  char* argv[] = {words[0].data(), words[1].data(), words[2].data()};
  testing::internal::CaptureStderr();
  EXPECT_EQ(cli::run(3, argv, {.commands = kActions}), cli::kFailed);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), words[2] + ": error: the file can't be read\n");
}

}  // namespace
}  // namespace pongsim::ros2
