// The bridge for clients of later releases; the peers use Debian's library with messages of the later names.

#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ign/bridge.hh"
#include "ign/library.hh"
#include "ign/names.hh"
#include "ign/subscriber_list.hh"
#include "support/ign/bridged_peers.hh"
#include "support/ign/discovery_packet.hh"
#include "support/process.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

using ignition::msgs::StringMsg;
using test::Process;

class GzBridgeTest : public BridgedPeers {
 protected:
  GzBridgeTest() : BridgedPeers(GZ_PEER, Generation::kGz) {}
  static void SetUpTestSuite() { usePartition("gz_bridge_test"); }
};

TEST_F(GzBridgeTest, SendsTopicsWithTheirLaterTypes) {
  Publisher publisher = node_.advertise<StringMsg>("/out");
  const auto listener = peer({"listen", "/out", "gz.msgs.StringMsg"});
  const auto names = peer({"raw", "/out"});
  const auto texts = peer({"texts", "/out"}, "");
  const auto has = [](const Process& process, const std::string& text) {
    return process.output().find(text) != std::string::npos;
  };
  EXPECT_TRUE(stepUntil([&] {
    StringMsg message;
    message.set_data("hello");
    publisher.publish(message);
    return has(*listener, "heard") && has(*names, "gz.msgs.StringMsg") && has(*texts, "hello");
  }));
  EXPECT_FALSE(has(*names, "ignition"));
  for (const auto& each : {&listener, &names, &texts}) (*each)->kill(SIGINT);
  EXPECT_TRUE(stepUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(GzBridgeTest, BringsInWhatTheWorldListensTo) {
  std::vector<std::string> heard;
  const Subscription subscription =
      node_.subscribe<StringMsg>("/in", [&heard](const StringMsg& message) { heard.push_back(message.data()); });
  step();
  const auto speaker = peer({"publish", "/in", "a", "b", "c"}, "");
  EXPECT_TRUE(stepUntil([&] { return heard.size() >= 3; }));
  EXPECT_EQ(heard, (std::vector<std::string>{"a", "b", "c"}));
}

TEST_F(GzBridgeTest, OffersServicesWithTheirLaterTypes) {
  std::vector<std::string> told;
  const Service twice = node_.serve<StringMsg, StringMsg>("/twice", [](const StringMsg& request, StringMsg& reply) {
    reply.set_data(request.data() + request.data());
    return request.data() != "no";
  });
  const Service tell = node_.serve("/tell", "ignition.msgs.StringMsg", kNoReply, [&](const Message& request, Message&) {
    told.push_back(static_cast<const StringMsg&>(request).data());
    return true;
  });
  step();
  const auto caller = peer({"call", "/twice", "ab"}, "");
  EXPECT_TRUE(stepUntilSaid(*caller, "abab")) << caller->output() << caller->error();
  const auto refused = peer({"call", "/twice", "no"}, "");
  EXPECT_TRUE(stepUntilSaid(*refused, "refused")) << refused->output() << refused->error();
  const auto teller = peer({"call-one-way", "/tell", "ab"}, "");
  EXPECT_TRUE(stepUntil([&] { return !told.empty(); })) << teller->output() << teller->error();
}

TEST_F(GzBridgeTest, ReachesServicesThatOnlyOthersOffer) {
  const auto server = peer({"serve", "/there"});
  const auto other = peer({"serve-one-way", "/told"});
  step();
  StringMsg request, reply;
  request.set_data("ab");
  const auto call = [&](const char* service, const Message& sent, Message& answer) {
    return node_.call(service, sent, answer, std::chrono::seconds(20));
  };
  EXPECT_TRUE(test::waitUntil([&] { return call("/there", request, reply).outcome == CallOutcome::kDone; }));
  EXPECT_EQ(reply.data(), "abab");
  ignition::msgs::Empty none;
  EXPECT_TRUE(test::waitUntil([&] { return call("/told", request, none).outcome == CallOutcome::kDone; }));
  EXPECT_TRUE(other->waitForOutput("ab"));
  const CallResult mistaken = call("/there", ignition::msgs::Twist(), reply);
  EXPECT_EQ(mistaken.outcome, CallOutcome::kOtherTypes);
  EXPECT_EQ(mistaken.error, "service '/there' takes ignition.msgs.StringMsg and returns ignition.msgs.StringMsg");
}

TEST_F(GzBridgeTest, TellsWhoAsksToWhatTheWorldSubscribes) {
  const Subscription subscription = node_.subscribe<StringMsg>("/in", [](const StringMsg&) {});
  const Subscription any = node_.subscribeAnyType("/any", [](std::string_view, auto) {});
  step();
  GroupListener listener(library().discoveryIP, library().msgDiscPort);
  const std::string request =
      packetOf("somebody", static_cast<ignition::msgs::Discovery::Type>(SubscriberList::kRequest));
  std::map<std::string, std::string> told;
  EXPECT_TRUE(stepUntil([&] {
    EXPECT_TRUE(sayToGroup(request, library().discoveryIP, library().msgDiscPort));
    while (const auto message = listener.next()) {
      if (static_cast<int>(message->type()) != SubscriberList::kReply) continue;
      if (message->process_uuid() != library().pUuid) continue;
      EXPECT_EQ(message->version(), 10U);
      EXPECT_EQ(message->pub().address(), library().myAddress);
      told[message->pub().topic()] = message->pub().msg_pub().msg_type();
    }
    return told.size() >= 2;
  }));
  EXPECT_EQ(told[wireName("/in").value()], "gz.msgs.StringMsg");
  EXPECT_EQ(told[wireName("/any").value()], "google.protobuf.Message");
}

}  // namespace
}  // namespace pongsim::ign
