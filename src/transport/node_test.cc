#include "pongsim/node.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/process.hh"
#include "support/regex.hh"
#include "support/test_domain.hh"
#include "support/transport/transport_peers.hh"

namespace pongsim {

namespace {

using ignition::msgs::StringMsg;
using test::kDeadline;
using test::Process;

StringMsg text(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

class NodeTest : public test::TransportPeersTest {
 protected:
  bool dispatchUntil(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    while (!done() && std::chrono::steady_clock::now() < deadline) {
      transport_.dispatchFor(std::chrono::milliseconds(20));
    }
    return done();
  }

  /// Publishes until a process that may still have to find the publisher has heard it; counts in `sent`.
  bool publishUntilHeard(Publisher& publisher, Process& process, int& sent) {
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    while (std::chrono::steady_clock::now() < deadline) {
      publisher.publish(text("again"));
      ++sent;
      if (process.waitForOutput("got again", std::chrono::milliseconds(20))) return true;
    }
    return false;
  }

  /// @param side Publishers or subscribers.
  /// @return What has passed a process on "/chatter"; nothing at all where it does not answer.
  static TopicInfo::Traffic trafficOf(int pid,
                                      const std::function<std::vector<TopicInfo::Endpoint>(const TopicInfo&)>& side) {
    Transport watcher;
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    // a busy machine may take longer to find them
    while (std::chrono::steady_clock::now() < deadline) {
      for (const auto& each : side(watcher.watchTopic("/chatter", std::chrono::milliseconds(300)))) {
        if (each.pid == pid && each.traffic) return *each.traffic;
      }
    }
    ADD_FAILURE() << "process " << pid << " does not answer";
    return {};
  }
};

}  // namespace

TEST_F(NodeTest, DeliversToAnotherProcess) {
  const auto other = listener();
  Publisher publisher = node_.advertise<StringMsg>("chatter");
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  EXPECT_TRUE(publisher.hasSubscribers());
  publisher.publish(text("hello"));
  EXPECT_TRUE(publisher.waitForDelivery(kDeadline));
  EXPECT_TRUE(other->waitForOutput("got hello"));
}

TEST_F(NodeTest, HearsAllThatAnotherProcessSaysInOrder) {
  std::vector<std::string> heard;
  const Subscription subscription =
      node_.subscribe<StringMsg>("/chatter", [&](const StringMsg& message) { heard.push_back(message.data()); });
  const auto other = peer({"say", "/chatter", "500", "0"});
  EXPECT_TRUE(dispatchUntil([&] { return heard.size() >= 500; }));
  EXPECT_EQ(other->wait(), 0);
  ASSERT_EQ(heard.size(), 500);
  for (std::size_t i = 0; i < heard.size(); ++i) EXPECT_EQ(heard[i], std::to_string(i));
}

TEST_F(NodeTest, HearsItselfOnceWhenOthersListenToo) {
  int heard = 0;
  const Subscription subscription = node_.subscribe<StringMsg>("/chatter", [&](const StringMsg&) { ++heard; });
  const auto other = listener();
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  int sent = 0;
  ASSERT_TRUE(publishUntilHeard(publisher, *other, sent));
  for (int i = 0; i < 100; ++i, ++sent) publisher.publish(text(std::to_string(i)));
  // acknowledged by this process's own reader, too, so that nothing more can come
  EXPECT_TRUE(other->waitForOutput("got 99\n"));
  EXPECT_TRUE(publisher.waitForDelivery(kDeadline));
  transport_.dispatch();
  EXPECT_EQ(heard, sent);
}

TEST_F(NodeTest, TalksToAnotherTransportOfTheProcess) {
  Transport second;
  std::string heard;
  const Subscription subscription =
      second.node().subscribe<StringMsg>("/chatter", [&](const StringMsg& message) { heard = message.data(); });
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  publisher.publish(text("hello"));
  while (heard.empty() && second.dispatchFor(kDeadline) > 0) continue;
  EXPECT_EQ(heard, "hello");
}

TEST_F(NodeTest, CarriesLargeMessages) {
  const auto other = listener();
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  for (std::size_t size : {65'000, 65'536, 1'000'003, 6'000'001}) {
    publisher.publish(text(std::string(size, 'x')));
    EXPECT_TRUE(other->waitForOutput("got " + std::to_string(size) + " bytes")) << size;
  }
}

TEST_F(NodeTest, IsNotHeldUpByAStoppedSubscriber) {
  const auto other = listener();
  const auto healthy = listener();
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  int sent = 0;
  ASSERT_TRUE(publishUntilHeard(publisher, *other, sent));
  ASSERT_TRUE(publishUntilHeard(publisher, *healthy, sent));
  ASSERT_TRUE(publisher.waitForDelivery(kDeadline));
  other->kill(SIGSTOP);
  // more than is kept for it
  for (int i = 0; i < 3000; ++i) publisher.publish(text(std::to_string(i)));
  EXPECT_FALSE(publisher.waitForDelivery(std::chrono::milliseconds(10)));
  EXPECT_TRUE(healthy->waitForOutput("got 2999"));
  other->kill(SIGCONT);
  EXPECT_TRUE(other->waitForOutput("got 2999"));

  // each of them was heard or is counted
  const std::string output = other->output();
  const std::size_t heard = test::Regex("got \\d+\n").allIn(output).size();
  EXPECT_EQ(trafficOf(other->pid(), [](const TopicInfo& topic) { return topic.subscribers; }).dropped, 3000 - heard);
  EXPECT_GE(trafficOf(getpid(), [](const TopicInfo& topic) { return topic.publishers; }).dropped, 3000 - heard);
}

TEST_F(NodeTest, CountsTheSubscribersThatHaveComeSinceItWasAsked) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  EXPECT_EQ(publisher.newSubscribers(), 0);
  const Subscription first = node_.subscribe<StringMsg>("/chatter", [](const StringMsg&) {});
  const Subscription second = node_.subscribe<StringMsg>("/chatter", [](const StringMsg&) {});
  EXPECT_EQ(publisher.newSubscribers(), 2);
  EXPECT_EQ(publisher.newSubscribers(), 0);

  const auto other = listener();
  std::uint64_t come = 0;
  EXPECT_TRUE(dispatchUntil([&] { return (come += publisher.newSubscribers()) > 0; }));
  EXPECT_EQ(come, 1);
  publisher.publish(text("welcome"));
  EXPECT_TRUE(other->waitForOutput("got welcome"));
}

TEST_F(NodeTest, GoesOnAfterAKilledSubscriber) {
  auto other = listener();
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  other->kill(SIGKILL);
  other->wait();
  for (int i = 0; i < 3000; ++i) publisher.publish(text(std::to_string(i)));
  const auto next = listener();
  int sent = 0;
  EXPECT_TRUE(publishUntilHeard(publisher, *next, sent));
}

TEST_F(NodeTest, EndsAPublisherThatASubscriberHasNotAnswered) {
  const auto other = listener();
  // long enough for heartbeats to come while they end
  for (int i = 0; i < 100; ++i) {
    {
      Publisher publisher = node_.advertise<StringMsg>("/chatter");
      ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
      other->kill(SIGSTOP);
      for (int k = 0; k < 1000; ++k) publisher.publish(text(std::to_string(k)));
    }
    // or it would be forgotten where all this takes long
    other->kill(SIGCONT);
  }
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  int sent = 0;
  EXPECT_TRUE(publishUntilHeard(publisher, *other, sent));
}

TEST_F(NodeTest, GivesWhatIsLatchedToWhoComesLaterAndOnce) {
  Publisher publisher = node_.advertise<StringMsg>("/scene", {.latched = true});
  publisher.publish(text("old"));
  publisher.publish(text("scene"));
  const auto first = listener("/scene");
  ASSERT_TRUE(first->waitForOutput("got scene\n"));
  const auto second = listener("/scene");
  ASSERT_TRUE(second->waitForOutput("got scene\n"));
  publisher.publish(text("new"));
  for (const auto* other : {&first, &second}) {
    ASSERT_TRUE((*other)->waitForOutput("got new\n"));
    EXPECT_EQ((*other)->output(), "ready\ngot scene\ngot new\n");
  }
}

TEST_F(NodeTest, HearsWhatAnotherProcessLatchedInEverySubscription) {
  auto other = peer({"latch", "/scene", "scene"});
  ASSERT_TRUE(other->waitForOutput("ready"));
  std::vector<std::string> heard;
  const auto note = [&heard](const StringMsg& message) { heard.push_back(message.data()); };
  const Subscription first = node_.subscribe<StringMsg>("/scene", note);
  EXPECT_TRUE(dispatchUntil([&] { return heard.size() == 1; }));
  const Subscription second = node_.subscribe<StringMsg>("/scene", note);
  EXPECT_TRUE(dispatchUntil([&] { return heard.size() == 2; }));
  EXPECT_EQ(heard, (std::vector<std::string>{"scene", "scene"}));
  EXPECT_EQ(first.dropped() + second.dropped(), 0);

  // when it has gone, so has what it latched
  other->kill(SIGTERM);
  EXPECT_EQ(other->wait(), 0);
  EXPECT_TRUE(dispatchUntil([&] { return transport_.waitForTopic("/scene", true, {}).publishers.empty(); }));
  const Subscription third = node_.subscribe<StringMsg>("/scene", note);
  transport_.dispatch();
  EXPECT_EQ(heard.size(), 2);
}

TEST_F(NodeTest, CountsWhatASubscriberThatIsStoppedLoses) {
  Transport sender;
  Publisher publisher = sender.node().advertise<StringMsg>("/chatter");
  int heard = 0;
  // one that does not dispatch stands for one that is stopped: the same messages are dropped here that would be there
  const Subscription slow = node_.subscribe<StringMsg>("/chatter", [&](const StringMsg&) { ++heard; });
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  // what is given up before the first one has come is nothing that it could know of
  publisher.publish(text("x"));
  ASSERT_TRUE(dispatchUntil([&] { return heard == 1; }));
  for (int i = 1; i < 3000; ++i) publisher.publish(text("x"));
  EXPECT_EQ(publisher.sent(), 3000);
  ASSERT_TRUE(publisher.waitForDelivery(kDeadline));
  EXPECT_TRUE(dispatchUntil([&] { return slow.received() + slow.dropped() == 3000; }));
  transport_.dispatch();
  EXPECT_EQ(slow.received(), heard);
  EXPECT_GT(slow.dropped(), 0);
}

TEST_F(NodeTest, CountsNoLossesOfOthersForASubscriptionToItsOwnTransport) {
  Transport sender;
  Publisher publisher = sender.node().advertise<StringMsg>("/chatter");
  Subscription slow = node_.subscribe<StringMsg>("/chatter", [](const StringMsg&) {});
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  // more at once than is kept for a reader that has not answered
  const StringMsg large = text(std::string(std::size_t{8} << 20, 'x'));
  ASSERT_TRUE(dispatchUntil([&] {
    for (int i = 0; i < 6; ++i) publisher.publish(large);
    return slow.dropped() > 0;
  }));
  const Subscription own = node_.subscribe<StringMsg>("/chatter", [](const StringMsg&) {}, {.ownOnly = true});
  slow = {};
  const Subscription next = node_.subscribe<StringMsg>("/chatter", [](const StringMsg&) {});
  EXPECT_EQ(own.dropped(), 0);
}

TEST_F(NodeTest, KnowsThePeersTraffic) {
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  const auto other = listener();
  ASSERT_TRUE(publisher.waitForSubscribers(kDeadline));
  for (int i = 0; i < 5; ++i) publisher.publish(text("x"));
  ASSERT_TRUE(other->waitForOutput("(got x\n){5}"));

  const auto publishers = [](const TopicInfo& topic) { return topic.publishers; };
  const auto subscribers = [](const TopicInfo& topic) { return topic.subscribers; };
  EXPECT_EQ(trafficOf(getpid(), publishers), (TopicInfo::Traffic{5, 0, 0}));
  EXPECT_EQ(trafficOf(other->pid(), subscribers), (TopicInfo::Traffic{5, 0, 0}));
  EXPECT_FALSE(transport_.waitForTopic("/chatter", false, kDeadline).subscribers.at(0).traffic) << "nobody has asked";
}

TEST_F(NodeTest, ServesTenProcesses) {
  std::vector<std::unique_ptr<Process>> others;
  for (int i = 0; i < 10; ++i) others.push_back(peer({"listen", "/chatter"}));
  for (const auto& other : others) ASSERT_TRUE(other->waitForOutput("ready"));
  Publisher publisher = node_.advertise<StringMsg>("/chatter");
  // those that listen are known by now to `discover`; they come to know of the publisher each in its own time
  EXPECT_EQ(transport_.discover(kDeadline).at(0).subscribers.size(), 10);
  int sent = 0;
  for (const auto& other : others) EXPECT_TRUE(publishUntilHeard(publisher, *other, sent));
}

TEST_F(NodeTest, WarnsWhenAnotherProcessSpeaksAnotherType) {
  testing::internal::CaptureStderr();
  Publisher publisher = node_.advertise<ignition::msgs::Int32>("/chatter");
  const auto other = listener();
  transport_.waitForTopic("/chatter", false, kDeadline);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_FALSE(publisher.hasSubscribers());
  for (const std::string& part : {std::string("/chatter"), std::string("ignition.msgs.Int32"),
                                  std::string("ignition.msgs.StringMsg"), std::to_string(other->pid())}) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

}  // namespace pongsim
