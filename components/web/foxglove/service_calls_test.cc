#include "web/foxglove/service_calls.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;
using namespace std::string_literals;

class CallsTest : public SessionTest {
 protected:
  Service serve(const std::string& name) {
    return world_.node().serve<im::StringMsg, im::Boolean>(name, [](const im::StringMsg& request, im::Boolean& reply) {
      reply.set_data(true);
      return request.data() == "yes" ? ServiceAnswer(true) : ServiceAnswer::refused("it says no");
    });
  }
};

TEST_F(CallsTest, AnswersInTheFormOfTheRequest) {
  const Service offered = serve("/s");
  open();
  const std::uint32_t id = service("/s")["id"];
  say(callOf(id, "json", R"({"data": "yes"})"));
  EXPECT_EQ(awaitBinary('\3'), number(id) + number(77) + number(4) + R"(json{"data":true})");
  im::StringMsg yes;
  yes.set_data("yes");
  im::Boolean answer;
  answer.set_data(true);
  say(callOf(id, "protobuf", yes.SerializeAsString()));
  EXPECT_EQ(awaitBinary('\3'), number(id) + number(77) + number(8) + "protobuf" + answer.SerializeAsString());
}

TEST_F(CallsTest, SaysWhatServicesTake) {
  const Service offered = serve("/s");
  open();
  const json forFoxglove = service("/s");
  EXPECT_EQ(forFoxglove["request"]["encoding"], "json");
  // not the names of the channels' types, whose protobuf schemas differ
  EXPECT_EQ(forFoxglove["request"]["schemaName"], "ignition.msgs.StringMsg_Request");
  EXPECT_EQ(forFoxglove["response"]["schemaName"], "ignition.msgs.Boolean_Response");
  const json request = json::parse(forFoxglove["request"]["schema"].get<std::string>());
  EXPECT_EQ(request["properties"]["data"]["type"], "string");
  const json response = json::parse(forFoxglove["response"]["schema"].get<std::string>());
  EXPECT_EQ(response["properties"]["data"]["type"], "boolean");
  open("pongsim.web.v1");
  const json forOurPage = service("/s");
  EXPECT_EQ(forOurPage["request"]["encoding"], "protobuf");
  EXPECT_FALSE(forOurPage["request"]["schema"].get<std::string>().empty());
}

TEST_F(CallsTest, TellsThatAServiceHasGone) {
  Service offered = serve("/s");
  open();
  const json there = service("/s");
  offered = {};
  EXPECT_EQ(await("unadvertiseServices")["serviceIds"], json{there["id"]});
}

TEST_F(CallsTest, SaysWhyThereIsNoAnswer) {
  const Service offered = serve("/s");
  open();
  const std::uint32_t id = service("/s")["id"];
  const auto failure = [&](const std::string& call) {
    say(call);
    const json told = await("serviceCallFailure");
    EXPECT_EQ(told["callId"], 77);
    return told["message"].get<std::string>();
  };
  EXPECT_NE(failure(callOf(id, "json", R"({"data": "no"})")).find("it says no"), std::string::npos);
  EXPECT_NE(failure(callOf(id, "json", "rubbish")).find("is not of type ignition.msgs.StringMsg"), std::string::npos);
  EXPECT_EQ(failure(callOf(id, "protobuf", "\xff")), "1 bytes are not of type ignition.msgs.StringMsg");
  EXPECT_EQ(failure(callOf(id, "cdr", "")), "requests must be protobuf or json, not 'cdr'");
  EXPECT_EQ(failure(callOf(999, "json", "{}")), "there is no service 999");
}

TEST_F(CallsTest, OffersWhatChangesNothingToWhoMayOnlyLook) {
  client_->setMayWrite(false);
  const Service control = serve("/world/w/control");
  const Service state = serve("/world/w/state");
  open();
  ASSERT_TRUE(world_.stepUntil([&] { return worlds_->services().size() == 2; }));
  const json told = await("advertiseServices");
  ASSERT_EQ(told["services"].size(), 1U);
  EXPECT_EQ(told["services"][0]["name"], "/world/w/state");
}

}  // namespace
}  // namespace pongsim::web::foxglove
