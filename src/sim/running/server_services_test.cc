#include "sim/running/server_services.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <string>

#include "support/ask_service.hh"

namespace pongsim::sim::server_services_test {
namespace {

class ServerServicesTest : public testing::Test {
 protected:
  std::string control(const std::string& text) {
    const MessagePointer request = newMessage("ServerControl");
    EXPECT_FALSE(parseMessage(text, *request));
    ignition::msgs::Boolean reply;
    const CallResult result = test::askService(transport_, "/server_control", *request, reply);
    return result ? std::to_string(reply.data()) : test::refusalOf(result);
  }

  int stops_ = 0;
  Transport transport_{{.network = false}};
  ServerServices services_{transport_, {"one", "two worlds"}, [this] { ++stops_; }};
};

TEST_F(ServerServicesTest, TellAllWorldsInTheirOrder) {
  ignition::msgs::StringMsg_V worlds;
  EXPECT_TRUE(test::askService(transport_, "/gazebo/worlds", *newMessage("Empty"), worlds));
  ASSERT_EQ(worlds.data_size(), 2);
  EXPECT_EQ(worlds.data(0), "one");
  EXPECT_EQ(worlds.data(1), "two worlds");
}

TEST_F(ServerServicesTest, EndTheRunAndDoNothingElse) {
  EXPECT_EQ(control("stop: true, clone: true"), "only 'stop: true' is supported");
  EXPECT_EQ(control(""), "only 'stop: true' is supported");
  EXPECT_EQ(stops_, 0);
  EXPECT_EQ(control("stop: true"), "1");
  EXPECT_EQ(stops_, 1);
}

}  // namespace
}  // namespace pongsim::sim::server_services_test
