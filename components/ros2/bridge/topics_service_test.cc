#include "ros2/bridge/topics_service.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/param_v.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

TEST(TopicsService, TellsWhatIsBridged) {
  Participant participant({.domain = test::testDomain()});
  Transport transport({.network = false});
  Node simulation = transport.node();
  RosNode ros(participant, {});
  Bridge bridge(simulation, ros, {});
  const TopicsService service(simulation, "my world", bridge);
  EXPECT_EQ(topicsServiceOf("my world"), "/world/my_world/ros2/topics");
  const Publisher publisher = simulation.advertise<ignition::msgs::StringMsg>("/chatter");
  bridge.update();

  ignition::msgs::Param_V told;
  const PendingRequest request =
      simulation.request(topicsServiceOf("my world"), ignition::msgs::Empty(), "ignition.msgs.Param_V",
                         [&](const CallResult& result, const Message& reply) {
                           EXPECT_TRUE(result) << result.error;
                           told.CopyFrom(reply);
                         });
  transport.dispatch();
  ASSERT_EQ(told.param_size(), 1);
  const auto& params = told.param(0).params();
  EXPECT_EQ(params.at("ros").string_value(), "/chatter");
  EXPECT_EQ(params.at("ros_type").string_value(), "std_msgs/msg/String");
  EXPECT_EQ(params.at("ignition").string_value(), "/chatter");
  EXPECT_EQ(params.at("ignition_type").string_value(), "ignition.msgs.StringMsg");
  EXPECT_TRUE(params.at("to_ros").bool_value());
  EXPECT_FALSE(params.at("from_ros").bool_value());
  for (const char* number : {"readers", "writers", "sent", "received", "dropped", "refused"})
    EXPECT_EQ(params.at(number).double_value(), 0) << number;
}

}  // namespace
}  // namespace pongsim::ros2
