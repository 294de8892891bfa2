#include "ign/bridge.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ign/names.hh"
#include "pongsim/commands.hh"
#include "support/ign/bridged_peers.hh"
#include "support/process.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

using ignition::msgs::StringMsg;
using test::Process;

StringMsg textOf(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

constexpr int kQueue = 20;

class BridgeTest : public BridgedPeers {
 protected:
  BridgeTest() : BridgedPeers(IGN_PEER, Generation::kIgn) {}
  static void SetUpTestSuite() {
    usePartition("bridge_test");
    setenv("IGN_TRANSPORT_SNDHWM", std::to_string(kQueue).c_str(), 1);
  }
  Subscription note(const std::string& topic, std::vector<std::string>& heard) {
    return node_.subscribe<StringMsg>(topic, [&heard](const StringMsg& message) { heard.push_back(message.data()); });
  }
};

TEST_F(BridgeTest, TakesATopicThereWhileSomebodyListens) {
  Publisher publisher = node_.advertise<StringMsg>("/out");
  step();
  EXPECT_FALSE(publisher.hasSubscribers());
  const auto listener = peer({"listen", "/out", "ignition.msgs.StringMsg"});
  EXPECT_TRUE(stepUntil([&] { return publisher.hasSubscribers(); }));
  EXPECT_TRUE(stepUntil([&] {
    publisher.publish(textOf("hello"));
    return listener->output().find("heard") != std::string::npos;
  }));
  listener->kill(SIGINT);
  EXPECT_TRUE(stepUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(BridgeTest, LetsGoOfAListenerThatIsKilled) {
  Publisher publisher = node_.advertise<StringMsg>("/out");
  const auto listener = peer({"listen", "/out", "ignition.msgs.StringMsg"});
  EXPECT_TRUE(stepUntil([&] { return publisher.hasSubscribers(); }));
  listener->kill(SIGKILL);
  EXPECT_TRUE(stepUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(BridgeTest, HoldsNoMoreThanTheQueueForAListenerThatIsStopped) {
  Publisher publisher = node_.advertise<ignition::msgs::Image>("/camera");
  const auto stopped = peer({"listen", "/camera", "ignition.msgs.Image"});
  const auto other = peer({"listen", "/camera", "ignition.msgs.Image"});
  constexpr std::size_t kSize = 1 << 20;
  const Bulk bulk{.size = kSize, .write = [](std::span<std::byte> place) { std::ranges::fill(place, std::byte(1)); }};
  EXPECT_TRUE(stepUntil([&] {
    publisher.publish(ignition::msgs::Image(), bulk);
    return stopped->output().find("heard") != std::string::npos && other->output().find("heard") != std::string::npos;
  }));
  stopped->kill(SIGSTOP);
  for (int i = 0; i < 10 * kQueue; ++i) {
    publisher.publish(ignition::msgs::Image(), bulk);
    // messages still queued for the courier's thread are not in ZeroMQ's queues
    EXPECT_TRUE(stepUntil([] { return Payload::total() < (2 * kQueue + 10) * kSize; }));
  }
  EXPECT_TRUE(stepUntil([] { return Payload::total() < (kQueue + 10) * kSize; }));
  other->kill(SIGINT);
  EXPECT_TRUE(other->waitForOutput("\\n\\d+\\n"));
  EXPECT_GT(std::stoi(other->output().substr(other->output().rfind('\n', other->output().size() - 2) + 1)), kQueue);
  stopped->kill(SIGCONT);
}

TEST_F(BridgeTest, TellsTheTypeOfEachMessage) {
  Publisher publisher = node_.advertise<ignition::msgs::Image>("/camera");
  const auto listener = peer({"raw", "/camera"});
  const std::string pixels(100'000, 'x');
  const Bulk bulk{.size = pixels.size(), .write = [&](std::span<std::byte> place) {
                    std::ranges::copy(std::as_bytes(std::span(pixels)), place.begin());
                  }};
  EXPECT_TRUE(stepUntil([&] {
    publisher.publish(ignition::msgs::Image(), bulk);
    return listener->output().find("ignition.msgs.Image") != std::string::npos;
  }));
}

TEST_F(BridgeTest, BringsInWhatTheWorldListensTo) {
  std::vector<std::string> heard;
  const Subscription subscription = note("/in", heard);
  step();
  const auto speaker = peer({"publish", "/in", "a", "b", "c"}, "");
  EXPECT_TRUE(stepUntil([&] { return heard.size() >= 3; }));
  EXPECT_EQ(heard, (std::vector<std::string>{"a", "b", "c"}));
}

TEST_F(BridgeTest, BringsInTypesThatWereNotKnownBefore) {
  std::vector<std::string> types;
  const Subscription subscription =
      node_.subscribeAnyType("/any", [&types](std::string_view type, auto) { types.emplace_back(type); });
  step();
  const auto speaker = peer({"publish", "/any", "a", "b"}, "");
  EXPECT_TRUE(stepUntil([&] { return types.size() >= 2; }));
  EXPECT_EQ(types, (std::vector<std::string>(2, "ignition.msgs.StringMsg")));
}

TEST_F(BridgeTest, CarriesNothingOnAndNothingBack) {
  // a topic with a publisher and a subscription in the world, and a publisher and a subscription that relay messages
  Publisher publisher = node_.advertise<StringMsg>("/both");
  Publisher carrier = node_.advertise<StringMsg>("/both", {.relays = true});
  std::vector<std::string> heard, carried;
  const Subscription subscription = note("/both", heard);
  const Subscription other = node_.subscribe<StringMsg>(
      "/both", [&carried](const StringMsg& message) { carried.push_back(message.data()); }, {.relays = true});
  const auto listener = peer({"raw", "/both"});
  const auto speaker = peer({"publish", "/both", "from there"}, "");
  EXPECT_TRUE(stepUntil([&] { return !heard.empty(); }));
  EXPECT_EQ(heard, std::vector<std::string>{"from there"});
  carrier.publish(textOf("carried"));
  EXPECT_TRUE(stepUntil([&] { return heard.size() == 2; }));
  EXPECT_TRUE(carried.empty());
  // the other process has received only its own message, until the world publishes one
  const auto count = [&] {
    std::size_t lines = 0;
    const std::string text = listener->output();
    for (std::size_t at = text.find("StringMsg"); at != std::string::npos; at = text.find("StringMsg", at + 1)) ++lines;
    return lines;
  };
  EXPECT_TRUE(stepUntil([&] { return count() == 1; }));
  EXPECT_TRUE(stepUntil([&] {
    publisher.publish(textOf("from here"));
    return count() > 1;
  }));
  ASSERT_TRUE(stepUntil([&] { return !carried.empty(); }));
  EXPECT_EQ(carried.front(), "from here");
}

TEST_F(BridgeTest, OffersServicesOfAnyTypes) {
  const Service service = node_.serve<StringMsg, StringMsg>("/twice", [](const StringMsg& request, StringMsg& reply) {
    reply.set_data(request.data() + request.data());
    return request.data() != "no";
  });
  step();
  const auto caller = peer({"call", "/twice", "ab"}, "");
  EXPECT_TRUE(stepUntilSaid(*caller, "abab")) << caller->output() << caller->error();
  const auto refused = peer({"call", "/twice", "no"}, "");
  EXPECT_TRUE(stepUntilSaid(*refused, "refused")) << refused->output() << refused->error();
}

TEST_F(BridgeTest, OffersServicesWithoutAnAnswer) {
  std::vector<std::string> told;
  const Service service =
      node_.serve("/tell", "ignition.msgs.StringMsg", kNoReply, [&](const Message& request, Message&) {
        told.push_back(static_cast<const StringMsg&>(request).data());
        return true;
      });
  step();
  const auto caller = peer({"call-one-way", "/tell", "ab"}, "");
  EXPECT_TRUE(stepUntil([&] { return !told.empty(); })) << caller->output() << caller->error();
  EXPECT_EQ(told, std::vector<std::string>{"ab"});
}

TEST_F(BridgeTest, ReachesServicesWithoutAnAnswer) {
  const auto server = peer({"serve-one-way", "/told"});
  step();
  ignition::msgs::Empty none;
  // the call succeeds once discovery has found the service
  EXPECT_TRUE(test::waitUntil(
      [&] { return node_.call("/told", textOf("ab"), none, std::chrono::seconds(20)).outcome == CallOutcome::kDone; }));
  EXPECT_TRUE(server->waitForOutput("ab"));
}

TEST_F(BridgeTest, EndsWhileACallerWaits) {
  const Service service =
      node_.serve<StringMsg, StringMsg>("/never", [](const StringMsg&, StringMsg&) { return true; });
  auto other = std::make_unique<Bridge>(node_, log_, "127.0.0.1", Generation::kIgn);
  other->update();
  // the request is never dispatched, so it stays unanswered
  const auto caller = peer({"call", "/never", "a"}, "");
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  other.reset();
}

TEST_F(BridgeTest, ReachesServicesThatOnlyOthersOffer) {
  const auto server = peer({"serve", "/there"});
  StringMsg reply;
  const auto call = [&](const char* service, const std::string& text) {
    return node_.call(service, textOf(text), reply, std::chrono::seconds(20));
  };
  step();
  EXPECT_TRUE(test::waitUntil([&] { return call("/there", "ab").outcome == CallOutcome::kDone; }));
  EXPECT_EQ(reply.data(), "abab");
  EXPECT_EQ(call("/there", "no").outcome, CallOutcome::kRefused);
  EXPECT_EQ(call("/nowhere", "ab").outcome, CallOutcome::kNoService);
  ignition::msgs::Twist other;
  EXPECT_EQ(node_.call("/there", textOf("a"), other, std::chrono::seconds(20)).outcome, CallOutcome::kOtherTypes);
}

}  // namespace
}  // namespace pongsim::ign
