#include "ros2/robot/rival_publishers.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

class RivalPublishersTest : public testing::Test {
 protected:
  RivalPublishersTest() { rivals_.watchTransforms(); }

  /// @return What is said until `isSaid`.
  static std::string saidUntil(const std::string& text, const std::function<void()>& check) {
    testing::internal::CaptureStderr();
    std::string said;
    const auto end = std::chrono::steady_clock::now() + test::kDeadline;
    while (said.find(text) == std::string::npos && std::chrono::steady_clock::now() < end) {
      check();
      said += testing::internal::GetCapturedStderr();
      testing::internal::CaptureStderr();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return said + testing::internal::GetCapturedStderr();
  }

  const int domain_ = test::testDomain();
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {.name = "simulation"}};
  Participant otherParticipant_{{.domain = domain_}};
  RosNode other_{otherParticipant_, {.name = "driver"}};
  RivalPublishers rivals_{node_};
};

TEST_F(RivalPublishersTest, WarnOnceOfAFrameWithTwoParents) {
  const auto publisher = other_.advertise<tf2_msgs::TFMessage>("/tf");
  tf2_msgs::TFMessage message;
  message.transforms.resize(2);
  message.transforms[0].header.frame_id = "map";
  message.transforms[0].child_frame_id = "odom";
  message.transforms[1].header.frame_id = "wheel_odom";
  message.transforms[1].child_frame_id = "base_link";
  const std::string expected = "another node publishes the frame 'base_link' in 'wheel_odom'";
  const auto check = [&] {
    publisher->publish(message);
    rivals_.checkTransforms({"base_link", "wheel"});
  };
  const std::string said = saidUntil(expected, check);
  EXPECT_NE(said.find(expected), std::string::npos) << said;
  EXPECT_NE(said.find("--ros2-no-link-tf"), std::string::npos) << said;
  // of the other's own frames nothing is said
  EXPECT_EQ(said.find("'odom'"), std::string::npos) << said;
  testing::internal::CaptureStderr();
  for (int i = 0; i < 10; ++i) check();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(RivalPublishersTest, WarnOnceOfATopicWithTwoPublishers) {
  const auto ours = node_.advertise<tf2_msgs::TFMessage>("/joint_states");
  testing::internal::CaptureStderr();
  rivals_.checkTopic("/joint_states", "--ros2-no-joint-states", "joints have two sources");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const auto theirs = other_.advertise<tf2_msgs::TFMessage>("/joint_states");
  const std::string expected =
      "another node publishes '/joint_states', too: joints have two sources; --ros2-no-joint-states";
  const auto check = [&] { rivals_.checkTopic("/joint_states", "--ros2-no-joint-states", "joints have two sources"); };
  EXPECT_NE(saidUntil(expected, check).find(expected), std::string::npos);
  testing::internal::CaptureStderr();
  check();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pongsim::ros2
