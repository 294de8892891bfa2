#include "web/foxglove/session.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/session_of_a_world.hh"
#include "web/foxglove/wire.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;
using namespace std::string_literals;

TEST_F(SessionTest, BeginsWithWhatTheServerCan) {
  open();
  const json info = await("serverInfo");
  EXPECT_EQ(info["capabilities"], (json{"time", "services", "connectionGraph", "assets", "parameters",
                                        "parametersSubscribe", "clientPublish"}));
  EXPECT_EQ(info["supportedEncodings"], (json{"json", "protobuf"}));
  EXPECT_EQ(info["metadata"]["worlds"], R"(["w"])");
  client_->setMayWrite(false);
  open();
  await("advertise");
  EXPECT_FALSE(await("serverInfo")["capabilities"].contains("clientPublish"));
}

TEST_F(SessionTest, SendsWhatIsSubscribed) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  open();
  const json said = channel("/said");
  ASSERT_FALSE(said.is_null());
  say({{"op", "subscribe"}, {"subscriptions", {{{"id", 4}, {"channelId", said["id"]}}}}});
  ASSERT_TRUE(world_.stepUntil([&] { return publisher.hasSubscribers(); }));
  im::StringMsg message;
  message.set_data("x");
  publisher.publish(message);
  const std::string data = awaitBinary('\1');
  EXPECT_EQ(data.substr(0, 4), number(4));
  EXPECT_EQ(data.substr(12), message.SerializeAsString());
  say({{"op", "unsubscribe"}, {"subscriptionIds", {4}}});
  EXPECT_TRUE(world_.stepUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(SessionTest, TellsTheTime) {
  open();
  EXPECT_EQ(awaitBinary('\2').size(), 8U);
}

TEST_F(SessionTest, TellsThatATopicHasGone) {
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  open();
  const json said = channel("/said");
  publisher = {};
  EXPECT_EQ(await("unadvertise")["channelIds"], json{said["id"]});
}

TEST_F(SessionTest, OffersOwnChannelsToOurPageOnly) {
  open();
  const json others = await("advertise")["channels"];
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0]["topic"], "/foxglove/log");
  open("pongsim.web.v1");
  const json frame = channel("/world/w/frame");
  EXPECT_EQ(frame["encoding"], "pongsim");
  EXPECT_EQ(frame["schemaName"], "pongsim.Frame");
  say({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", frame["id"]}}}}});
  EXPECT_EQ(awaitBinary('\1'), number(1) + "\1\0\0\0\0\0\0\0"s + "frame");
}

TEST_F(SessionTest, PassesOnWhatOurPageAsksFor) {
  open("pongsim.web.v1");
  const json frame = channel("/world/w/frame");
  say({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", frame["id"]}}}}});
  say({{"op", "ask"}, {"subscriptionId", 1}, {"wrong", "there is no such picture"}});
  EXPECT_EQ(status(), "there is no such picture");
  say({{"op", "ask"}, {"subscriptionId", 2}});
  EXPECT_EQ(status(), "there is no subscription 2");
  say({{"op", "ask"}});
  EXPECT_EQ(status(), "the id of a subscription must be a number");
}

TEST_F(SessionTest, HandsOutAssets) {
  assets_.files["model://m/a.dae"] = "mesh";
  open();
  say({{"op", "fetchAsset"}, {"uri", "model://m/a.dae"}, {"requestId", 9}});
  EXPECT_EQ(awaitBinary('\4'), number(9) + "\0\0\0\0\0mesh"s);
  say({{"op", "fetchAsset"}, {"uri", "/etc/passwd"}, {"requestId", 9}});
  EXPECT_EQ(awaitBinary('\4').substr(0, 5), number(9) + "\1");
}

TEST_F(SessionTest, AnswersRubbishWithAWord) {
  open();
  for (const char* text : {"", "{", "[]", "3", "null", R"({"op": 3})", R"({"operation": "subscribe"})"}) {
    session_->text(text);
    EXPECT_EQ(status(), "a text message must be a JSON object with an 'op'") << text;
  }
  say({{"op", "dance"}});
  EXPECT_EQ(status(), "there is no operation 'dance'");
  for (const char* operation : {"subscribe", "unsubscribe", "advertise", "unadvertise", "fetchAsset"}) {
    say({{"op", operation}});
    EXPECT_NE(status().find(operation), std::string::npos);
  }
  say({{"op", "subscribe"}, {"subscriptions", {1, {{"id", -1}, {"channelId", 1}}, {{"id", "1"}, {"channelId", 1}}}}});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(status(), "a subscription must have an 'id' and a 'channelId'");
  say({{"op", "unsubscribe"}, {"subscriptionIds", {"x"}}});
  EXPECT_EQ(status(), "the id of a subscription must be a number");
  say({{"op", "unadvertise"}, {"channelIds", {nullptr}}});
  EXPECT_EQ(status(), "the id of a channel must be a number");
  say("\x09rubbish"s);
  EXPECT_EQ(status(), "there are no binary messages of kind 9");
  session_->text(std::string(1'000'000, '['));
  EXPECT_EQ(status(), "a text message must be a JSON object with an 'op'");
}

TEST_F(SessionTest, TellsTheTimeOfTheFirstWorldWhenItMovesOn) {
  open();
  world_.step();
  std::string bytes(1, '\x02');
  // little endian [ns]
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(1'000'000'000ULL >> (8 * i) & 0xff);
  for (int i = 0; i < 4; ++i) client_->free();
  EXPECT_EQ(client_->takeBinaries(), std::vector<std::string>{bytes});
}

TEST_F(SessionTest, TakesTenThousandSubscriptionsOfWhatIsNotThere) {
  open();
  json many = json::array();
  for (int i = 0; i < 10'000; ++i) many.push_back({{"id", i}, {"channelId", i + 100}});
  say({{"op", "subscribe"}, {"subscriptions", many}});
  EXPECT_EQ(client_->takeTexts().size(), 13U);
}

}  // namespace
}  // namespace pongsim::web::foxglove
