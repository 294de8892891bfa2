#include "ros2/command/description_source.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "ros2/node/parameters.hh"
#include "ros2/types/std_msgs.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

class DescriptionSourceTest : public testing::Test {
 protected:
  SearchOptions until(std::chrono::nanoseconds timeout) {
    return {timeout, [this](std::string_view what) {
              const std::lock_guard lock(mutex_);
              said_ += std::string(what) + "\n";
            }};
  }
  std::string said() {
    const std::lock_guard lock(mutex_);
    return said_;
  }
  static std_msgs::String textOf(const std::string& text) {
    std_msgs::String message;
    message.data = text;
    return message;
  }

  const int domain_ = test::testDomain();
  std::mutex mutex_;
  std::string said_;
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {.name = "create"}};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "publisher"}};
};

TEST_F(DescriptionSourceTest, TakesWhatATopicKeeps) {
  const auto publisher = peer_.advertise<std_msgs::String>("/robot_description", kLatchedQos);
  publisher->publish(textOf("<robot/>"));
  EXPECT_EQ(descriptionFromTopic(node_, "robot_description", until(test::kDeadline)), "<robot/>");
}

TEST_F(DescriptionSourceTest, SaysWhatItWaitsForAndGivesUp) {
  EXPECT_EQ(descriptionFromTopic(node_, "robot_description", until(std::chrono::milliseconds(1500))), std::nullopt);
  EXPECT_EQ(said(), "waiting for a message on '/robot_description'\n");
  EXPECT_THROW(descriptionFromTopic(node_, "robot-description", until(test::kDeadline)), std::invalid_argument);
}

TEST_F(DescriptionSourceTest, HintsAtAPublisherThatKeepsNothing) {
  const auto publisher = peer_.advertise<std_msgs::String>("/robot_description", kDefaultQos);
  auto waiting = std::async(std::launch::async,
                            [&] { return descriptionFromTopic(node_, "/robot_description", until(test::kDeadline)); });
  EXPECT_TRUE(test::waitUntil([&] { return said().find("durability is volatile") != std::string::npos; }));
  const auto other = peer_.advertise<std_msgs::String>("/robot_description", kLatchedQos);
  other->publish(textOf("<robot/>"));
  EXPECT_EQ(waiting.get(), "<robot/>");
}

TEST_F(DescriptionSourceTest, TakesTheParameterOfANode) {
  Parameters parameters(peer_, [] { return builtin_interfaces::Time(); });
  Parameters::Descriptor text, number;
  text.name = "robot_description";
  number.name = "number";
  parameters.declare(text, parameterOf(std::string("<robot/>")));
  parameters.declare(number, parameterOf(1.0));
  std::atomic<bool> isOver = false;
  std::jthread serving([&] {
    while (!isOver) {
      peer_.mailbox().dispatch();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  EXPECT_EQ(descriptionFromParameter(node_, "", "robot_description", until(test::kDeadline)), "<robot/>");
  EXPECT_EQ(descriptionFromParameter(node_, "publisher", "robot_description", until(test::kDeadline)), "<robot/>");
  EXPECT_TRUE(test::waitUntil([&] {
    EXPECT_EQ(descriptionFromParameter(node_, "/publisher", "number", until(std::chrono::seconds(2))), std::nullopt);
    return said().find("node '/publisher' has no parameter 'number' of type string") != std::string::npos;
  }));
  EXPECT_EQ(descriptionFromParameter(node_, "/nobody", "number", until(std::chrono::milliseconds(100))), std::nullopt);
  EXPECT_THROW(descriptionFromParameter(node_, "no-node", "x", until(test::kDeadline)), std::invalid_argument);
  isOver = true;
}

}  // namespace
}  // namespace pongsim::ros2
