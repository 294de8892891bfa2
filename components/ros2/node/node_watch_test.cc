#include "ros2/node/node_watch.hh"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "ros2/node/node.hh"
#include "ros2/node/service.hh"
#include "ros2/types/simulation_world_services.hh"
#include "ros2/types/std_msgs.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

bool becomesTrue(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + test::kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

class NodeWatchTest : public testing::Test {
 protected:
  NodeInfo infoOf(const std::string& name) const {
    for (const NodeInfo& node : watch_.nodes()) {
      if (node.fullName() == name) return node;
    }
    return {};
  }

  const int domain_ = test::testDomain();
  Participant participant_{{.domain = domain_}};
  NodeWatch watch_{participant_};
  Participant other_{{.domain = domain_}};
};

TEST_F(NodeWatchTest, SeesWhatNodesPublishSubscribeAndServe) {
  using Service = simulation_interfaces::srv::GetSimulatorFeatures;
  RosNode node(other_, {.name = "talker", .nameSpace = "/robot"});
  const auto publisher = node.advertise<std_msgs::String>("chatter");
  const auto subscription = node.subscribe<std_msgs::String>("/heard", [](const std_msgs::String&) {});
  const auto server =
      serveAtOnce<Service>(node, "features", [](const Service::Request&) { return Service::Response(); });
  ASSERT_TRUE(becomesTrue([&] {
    const NodeInfo info = infoOf("/robot/talker");
    return !info.publishes.empty() && !info.subscribes.empty() && !info.serves.empty();
  }));
  const NodeInfo info = infoOf("/robot/talker");
  EXPECT_EQ(info.nameSpace, "/robot");
  EXPECT_EQ(info.publishes, (std::vector<NodeInfo::Interface>{{"/robot/chatter", "std_msgs/msg/String"}}));
  EXPECT_EQ(info.subscribes, (std::vector<NodeInfo::Interface>{{"/heard", "std_msgs/msg/String"}}));
  EXPECT_EQ(info.serves,
            (std::vector<NodeInfo::Interface>{{"/robot/features", "simulation_interfaces/srv/GetSimulatorFeatures"}}));
  EXPECT_TRUE(info.calls.empty());
}

TEST_F(NodeWatchTest, ForgetsTheNodesOfAParticipantThatHasGone) {
  {
    Participant gone({.domain = domain_});
    RosNode node(gone, {.name = "guest"});
    ASSERT_TRUE(becomesTrue([&] { return infoOf("/guest").name == "guest"; }));
  }
  EXPECT_TRUE(becomesTrue([&] { return infoOf("/guest").name.empty(); }));
}

TEST_F(NodeWatchTest, SeesSeveralNodesOfAParticipant) {
  RosNode first(other_, {.name = "first"});
  {
    RosNode second(first, {.name = "second", .nameSpace = "/robot"});
    const auto publisher = second.advertise<std_msgs::String>("~/chatter");
    ASSERT_TRUE(becomesTrue([&] { return !infoOf("/robot/second").publishes.empty(); }));
    EXPECT_EQ(infoOf("/robot/second").publishes[0].name, "/robot/second/chatter");
    EXPECT_EQ(infoOf("/first").name, "first");
    EXPECT_TRUE(infoOf("/first").publishes.empty());
  }
  EXPECT_TRUE(becomesTrue([&] { return infoOf("/robot/second").name.empty(); }));
  EXPECT_EQ(infoOf("/first").name, "first");
}

TEST_F(NodeWatchTest, SettlesWhenWhoIsThereHasTold) {
  RosNode node(other_, {.name = "talker"});
  // on a busy machine nothing may arrive for that long before discovery
  EXPECT_TRUE(becomesTrue([&] {
    watch_.settle(test::kDeadline);
    return infoOf("/talker").name == "talker";
  }));
}

}  // namespace
}  // namespace pongsim::ros2
