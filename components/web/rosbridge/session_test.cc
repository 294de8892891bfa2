#include "web/rosbridge/session.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <optional>
#include <string>
#include <vector>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"

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
  RosTopics topics_{worlds_};
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
