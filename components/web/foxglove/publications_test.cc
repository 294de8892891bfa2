#include "web/foxglove/publications.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;

class PublicationsTest : public SessionTest {
 protected:
  static json channelOf(int id, const std::string& topic, const std::string& encoding, const std::string& type) {
    return {{"id", id}, {"topic", topic}, {"encoding", encoding}, {"schemaName", type}};
  }
  std::string fault(const json& channel) {
    say({{"op", "advertise"}, {"channels", {channel}}});
    return status();
  }
};

TEST_F(PublicationsTest, CarriesBothForms) {
  std::vector<std::string> received;
  const Subscription subscription = world_.node().subscribe<im::StringMsg>(
      "/asked", [&](const im::StringMsg& message) { received.push_back(message.data()); });
  open();
  say({{"op", "advertise"},
       {"channels",
        {channelOf(1, "/asked", "json", "gz.msgs.StringMsg"),
         channelOf(2, "/asked", "protobuf", "ignition.msgs.StringMsg")}}});
  im::StringMsg b;
  b.set_data("b");
  say("\x01" + number(1) + R"({"data": "a"})");
  say("\x01" + number(2) + b.SerializeAsString());
  ASSERT_TRUE(world_.stepUntil([&] { return received.size() == 2; }));
  EXPECT_EQ(received, (std::vector<std::string>{"a", "b"}));
  say({{"op", "unadvertise"}, {"channelIds", {1}}});
  say("\x01" + number(1) + "{}");
  EXPECT_EQ(status(), "the client has no channel 1");
}

TEST_F(PublicationsTest, SaysWhatIsWrong) {
  open();
  EXPECT_EQ(fault(3), "a channel must have an id, a topic, an encoding and a schemaName");
  EXPECT_EQ(fault(channelOf(1, "/t", "cdr", "StringMsg")), "messages on '/t' can be protobuf or json, not 'cdr'");
  EXPECT_EQ(fault(channelOf(1, "/t", "json", "ignition.msgs.StringMgs")),
            "there is no message type 'ignition.msgs.StringMgs'; did you mean 'ignition.msgs.StringMsg'?");
  EXPECT_EQ(fault(channelOf(1, "a b", "json", "StringMsg")), "the topic's name 'a b' has a space");
  say({{"op", "advertise"}, {"channels", {channelOf(1, "/t", "json", "StringMsg")}}});
  EXPECT_EQ(fault(channelOf(1, "/u", "json", "StringMsg")), "channel 1 already exists");
  say("\x01" + number(1) + "rubbish");
  EXPECT_NE(status().find("is not of type ignition.msgs.StringMsg"), std::string::npos);
  say({{"op", "unadvertise"}, {"channelIds", {5}}});
  EXPECT_EQ(status(), "the client has no channel 5");
}

TEST_F(PublicationsTest, LetsWhoMayOnlyLookPublishNothing) {
  client_->setMayWrite(false);
  open();
  EXPECT_EQ(fault(channelOf(1, "/t", "json", "StringMsg")), "this client is read-only: '/t' is not published on");
}

}  // namespace
}  // namespace pongsim::web::foxglove
