#include "web/rosbridge/session.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"
#include "web/rosbridge/cdr_json.hh"
#include "web/rosbridge/rosout.hh"

namespace pongsim::web::rosbridge {
namespace {

namespace im = ignition::msgs;
using nlohmann::json;

class RosbridgeSessionTest : public testing::Test {
 protected:
  /// Sends a request, and steps until there is a response.
  json answer(const json& request) { return answerTo(request.dump()); }
  json answerTo(const std::string& text) {
    session().text(text);
    std::vector<std::string> all;
    world_.stepUntil([&] {
      client_->free();
      for (const std::string& each : client_->takeTexts()) all.push_back(each);
      return !all.empty();
    });
    return all.size() == 1 ? json::parse(all.front()) : json();
  }
  RosbridgeSession& session() {
    if (!session_) session_.emplace(client_, worlds_, topics_);
    return *session_;
  }

  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
  RecentLog log_;
  RosTopics topics_{worlds_, log_};
  std::optional<RosbridgeSession> session_;
};

TEST_F(RosbridgeSessionTest, CallsServices) {
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/said", [](const im::StringMsg& request, im::Boolean& reply) {
        reply.set_data(request.data() == "yes");
        return true;
      });
  // the first request waits until the world has listed its services
  const json called = answer({{"op", "call_service"}, {"id", "7"}, {"service", "/said"}, {"args", {{"data", "yes"}}}});
  EXPECT_EQ(called, json({{"op", "service_response"},
                          {"id", "7"},
                          {"service", "/said"},
                          {"values", {{"data", true}}},
                          {"result", true}}));
  EXPECT_EQ(answer({{"op", "call_service"}, {"service", "/rosapi/services"}})["values"]["services"], json({"/said"}));
  const json wrong = answer({{"op", "call_service"}, {"service", "/said"}, {"args", {{"dat", "yes"}}}});
  EXPECT_EQ(wrong["result"], false);
  EXPECT_NE(wrong["values"].get<std::string>().find("dat"), std::string::npos);
  EXPECT_EQ(answer({{"op", "call_service"}, {"service", "/other"}})["values"], "there is no service '/other'");
}

TEST_F(RosbridgeSessionTest, TellsOfTheNodeAndItsTime) {
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/said", [](const auto&, auto&) { return true; });
  const auto asked = [&](const char* name, const json& arguments) {
    return answer({{"op", "call_service"}, {"service", name}, {"args", arguments}})["values"];
  };
  EXPECT_EQ(asked("/rosapi/nodes", json::object()), json({{"nodes", {"/pongsim"}}}));
  EXPECT_EQ(asked("/rosapi/node_details", {{"node", "/pongsim"}}),
            json({{"publishing", {"/rosout"}}, {"subscribing", json::array()}, {"services", {"/said"}}}));
  EXPECT_EQ(asked("/rosapi/node_details", {{"node", "/other"}})["services"], json::array());
  EXPECT_EQ(asked("/rosapi/services_for_type", {{"type", "ignition.msgs.StringMsg"}})["services"], json({"/said"}));
  EXPECT_EQ(asked("/rosapi/services_for_type", {{"type", "ignition.msgs.Twist"}})["services"], json::array());
  const json time = asked("/rosapi/get_time", json::object())["time"];
  EXPECT_TRUE(time["sec"].is_number_integer() && time["nanosec"].is_number_integer()) << time;
}

TEST_F(RosbridgeSessionTest, TellsWarningsOnRosout) {
  const json list = answer({{"op", "call_service"}, {"service", "/rosapi/topics_and_raw_types"}})["values"];
  EXPECT_EQ(list["topics"], json({"/rosout"}));
  EXPECT_EQ(list["types"], json({"rcl_interfaces/msg/Log"}));
  EXPECT_TRUE(readDefinition(list["typedefs_full_text"][0].get<std::string>()));
  EXPECT_EQ(answer({{"op", "call_service"},
                    {"service", "/rosapi/topics_for_type"},
                    {"args", {{"type", "rcl_interfaces/Log"}}}})["values"]["topics"],
            json({"/rosout"}));

  const Logger speaker("tests");
  speaker.warning("before");
  speaker.error("now");
  // one after the other, as data that may be dropped
  const json first = answer({{"op", "subscribe"}, {"topic", "/rosout"}, {"type", "rcl_interfaces/msg/Log"}});
  EXPECT_EQ(first["op"], "publish");
  EXPECT_EQ(first["msg"]["msg"], "before");
  EXPECT_EQ(first["msg"]["name"], "tests");
  EXPECT_EQ(first["msg"]["level"], 30);
  EXPECT_GT(first["msg"]["stamp"]["sec"], 0);
  client_->free();
  const std::vector<std::string> rest = client_->takeTexts();
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(json::parse(rest[0])["msg"]["msg"], "now");
  EXPECT_EQ(client_->traffic().counts().at("/rosout").messages, 2U);
}

TEST_F(RosbridgeSessionTest, SendsCdrAsItIs) {
  Logger("tests").warning("before");
  session().text(R"({"op": "subscribe", "topic": "/rosout", "compression": "cbor-raw"})");
  std::vector<std::string> sent;
  world_.stepUntil([&] {
    client_->free();
    sent = client_->takeBinaries();
    return !sent.empty();
  });
  const json publish = json::from_cbor(sent.front());
  EXPECT_EQ(publish["topic"], "/rosout");
  EXPECT_TRUE(publish["msg"]["secs"].is_number_integer() && publish["msg"]["nsecs"].is_number_integer());
  const std::vector<std::uint8_t>& bytes = publish["msg"]["bytes"].get_binary();
  EXPECT_EQ(readCdr(rosoutDefinition(), std::as_bytes(std::span(bytes)), Form::kJson)["msg"], "before");
  EXPECT_EQ(answer({{"op", "subscribe"}, {"topic", "/rosout"}, {"compression", "png"}})["msg"],
            "messages can have the compression 'none', 'cbor' or 'cbor-raw', not 'png'");
}

TEST_F(RosbridgeSessionTest, LetsReadersChangeNothing) {
  client_->setMayWrite(false);
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/said", [](const auto&, auto&) { return true; });
  EXPECT_EQ(answer({{"op", "call_service"}, {"service", "/said"}})["values"], "this client is read-only");
  EXPECT_EQ(answer({{"op", "call_service"}, {"service", "/rosapi/services"}})["values"]["services"], json::array());
  const json refused =
      answer({{"op", "advertise"}, {"topic", "/cmd_vel"}, {"type", "geometry_msgs/Twist"}, {"id", "a"}});
  EXPECT_EQ(refused, json({{"op", "status"},
                           {"level", "error"},
                           {"id", "a"},
                           {"msg", "this client is read-only: '/cmd_vel' is not published on"}}));
}

TEST_F(RosbridgeSessionTest, SaysWhatIsWrong) {
  for (const char* text : {"", "{", "[]", "3", "null", R"({"op": 3})", R"({"topic": "/a"})"}) {
    EXPECT_EQ(answerTo(text)["msg"], "a message must be an object in JSON with an 'op'") << text;
  }
  EXPECT_EQ(answer({{"op", "dance"}})["msg"], "there is no operation 'dance'");
  EXPECT_EQ(answer({{"op", "subscribe"}})["msg"], "a subscription must have a topic");
  EXPECT_EQ(answer({{"op", "unsubscribe"}, {"topic", "/a"}})["msg"], "there is no subscription to '/a'");
  EXPECT_EQ(answer({{"op", "advertise"}, {"topic", "/a"}})["msg"], "an advertisement must have a topic and a type");
  EXPECT_EQ(answer({{"op", "publish"}, {"topic", "/a"}})["msg"], "a message must have a topic and a msg");
  EXPECT_EQ(answer({{"op", "unadvertise"}, {"topic", "/a"}})["msg"], "'/a' has not been advertised");
}

TEST(RosbridgeMessages, AreToldFromThoseOfGazebosServer) {
  EXPECT_TRUE(isRosbridge(R"({"op": "subscribe"})"));
  EXPECT_FALSE(isRosbridge("sub,/topic,,"));
  EXPECT_FALSE(isRosbridge(""));
}

TEST(RosTypes, HaveTheirFullName) {
  EXPECT_EQ(fullRosType("geometry_msgs/Twist"), "geometry_msgs/msg/Twist");
  EXPECT_EQ(fullRosType("geometry_msgs/msg/Twist"), "geometry_msgs/msg/Twist");
  EXPECT_EQ(fullRosType(""), "");
}

}  // namespace
}  // namespace pongsim::web::rosbridge
