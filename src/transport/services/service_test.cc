#include "pongsim/service.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "transport/names/service_name.hh"
#include "transport/network/network.hh"

namespace pongsim {
namespace {

using ignition::msgs::Boolean;
using ignition::msgs::StringMsg;
using test::kDeadline;
using test::Process;

constexpr std::chrono::milliseconds kSoon{50};

StringMsg saying(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

std::unique_ptr<Process> peer(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), TRANSPORT_PEER);
  return std::make_unique<Process>(arguments);
}

std::unique_ptr<Process> server(const std::string& how) {
  auto process = peer({"serve", "/s", how});
  EXPECT_TRUE(process->waitForOutput("ready")) << process->error();
  return process;
}

/// A transport that another thread dispatches.
class Dispatched {
 public:
  explicit Dispatched(Transport& transport) : transport_(transport), thread_([this] { run(); }) {}
  ~Dispatched() {
    ended_ = true;
    transport_.wake();
    thread_.join();
  }
  Dispatched(const Dispatched&) = delete;
  Dispatched& operator=(const Dispatched&) = delete;

 private:
  void run() {
    while (!ended_) transport_.dispatchFor(std::chrono::milliseconds(20));
  }

  Transport& transport_;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

Service echo(Node node, const std::string& name) {
  return node.serve<StringMsg, StringMsg>(name, [](const StringMsg& request, StringMsg& reply) {
    reply.set_data(request.data() + "!");
    return true;
  });
}

class ServiceHere : public testing::Test {
 protected:
  Transport transport_{TransportOptions{.network = false, .domain = {}}};
  Node node_ = transport_.node();
  StringMsg reply_;
};

TEST_F(ServiceHere, AnswersWithoutANetwork) {
  const Service service = echo(node_, "s");
  const Dispatched dispatched(transport_);
  const CallResult result = node_.call("/s", saying("hello"), reply_, kDeadline);
  EXPECT_TRUE(result) << result.error;
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(reply_.data(), "hello!");
}

TEST_F(ServiceHere, RunsOnTheThreadThatDispatchesAfterTheMessages) {
  std::vector<std::string> order;
  std::thread::id ranOn;
  const Service service = node_.serve<StringMsg, StringMsg>("/s", [&](const StringMsg&, StringMsg&) {
    order.push_back("request");
    ranOn = std::this_thread::get_id();
    return true;
  });
  const Subscription subscription =
      node_.subscribe<StringMsg>("/t", [&](const StringMsg&) { order.push_back("message"); });
  Publisher publisher = node_.advertise<StringMsg>("/t");
  auto call = std::async(std::launch::async, [&] { return bool(node_.call("/s", saying(""), reply_, kDeadline)); });
  while (order.empty() || order.back() != "request") {
    publisher.publish(saying(""));
    transport_.dispatchFor(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(call.get());
  EXPECT_EQ(ranOn, std::this_thread::get_id());
  EXPECT_EQ(order.front(), "message");
}

TEST_F(ServiceHere, IsListedAmongTheTransportsOwn) {
  Transport transport({.network = false});
  Node node = transport.node();
  const std::uint64_t atFirst = node.ownServicesVersion();
  Service service = node.serve<StringMsg, Boolean>("s", [](const StringMsg&, Boolean&) { return true; });
  EXPECT_NE(node.ownServicesVersion(), atFirst);
  EXPECT_EQ(node.ownServices(), (std::vector<OwnService>{{"/s", "ignition.msgs.StringMsg", "ignition.msgs.Boolean"}}));
  const std::uint64_t before = node.ownServicesVersion();
  service = {};
  EXPECT_NE(node.ownServicesVersion(), before);
  EXPECT_TRUE(node.ownServices().empty());
}

TEST_F(ServiceHere, SaysWhatWentWrong) {
  EXPECT_EQ(node_.call("/s", saying(""), reply_, kDeadline).outcome, CallOutcome::kNoService);
  const Service service = echo(node_, "/s");
  const CallResult late = node_.call("/s", saying(""), reply_, kSoon);
  EXPECT_EQ(late.outcome, CallOutcome::kNoAnswer);
  EXPECT_EQ(late.error, "service '/s' did not answer in time");
  Boolean other;
  const CallResult wrong = node_.call("/s", saying(""), other, kDeadline);
  EXPECT_EQ(wrong.outcome, CallOutcome::kOtherTypes);
  EXPECT_EQ(wrong.error, "service '/s' takes ignition.msgs.StringMsg and returns ignition.msgs.StringMsg");
  EXPECT_THROW(node_.call("/a b", saying(""), reply_, kDeadline), std::invalid_argument);
}

TEST_F(ServiceHere, RefusesToWaitInAFunctionThatDispatchCalled) {
  bool threw = false;
  const Service service = echo(node_, "/s");
  const Subscription subscription = node_.subscribe<StringMsg>("/t", [&](const StringMsg&) {
    EXPECT_THROW(node_.call("/s", saying(""), reply_, kDeadline), std::logic_error);
    threw = true;
  });
  node_.advertise<StringMsg>("/t").publish(saying(""));
  transport_.dispatch();
  EXPECT_TRUE(threw);
}

TEST_F(ServiceHere, AnswersRequestsThatNobodyWaitsFor) {
  std::vector<std::string> order;
  const auto note = [&order](const CallResult& result, const Message& reply) {
    order.push_back(result ? static_cast<const StringMsg&>(reply).data() : result.error);
  };
  const auto ask = [&](const std::string& service, const char* what) {
    return node_.request(service, saying(what), "ignition.msgs.StringMsg", note);
  };
  EXPECT_FALSE(ask("/s", "nobody"));
  Service service = node_.serve<StringMsg, StringMsg>("/s", [&](const StringMsg& request, StringMsg& reply) {
    order.push_back("asked " + request.data());
    reply.set_data(request.data() + "!");
    return request.data() == "c" ? ServiceAnswer::refused("c is no word") : true;
  });
  EXPECT_FALSE(node_.request("/s", saying("a"), "ignition.msgs.Boolean", note)) << "it answers with texts";
  const PendingRequest a = ask("s", "a");
  ask("/s", "b");
  const PendingRequest c = ask("/s", "c");
  EXPECT_TRUE(a);
  EXPECT_TRUE(order.empty());
  transport_.dispatch();
  const std::vector<std::string> expected{"asked a", "a!", "asked b", "asked c", "service '/s' refused: c is no word"};
  EXPECT_EQ(order, expected) << "b's answer was not waited for";
  const PendingRequest d = ask("/s", "d");
  service = {};
  EXPECT_EQ(order.back(), "service '/s' ended before it answered");
  EXPECT_THROW(ask("/a b", ""), std::invalid_argument);
}

TEST_F(ServiceHere, TellsTheCallerWhenItEnds) {
  Service service = echo(node_, "/s");
  auto call = std::async(std::launch::async, [&] {
    CallOutcome outcome = CallOutcome::kNoService;
    while (outcome == CallOutcome::kNoService) outcome = node_.call("/s", saying(""), reply_, kDeadline).outcome;
    return outcome;
  });
  // nothing shows that the request waits, but it does some time
  while (call.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    service = Service();
    service = echo(node_, "/s");
  }
  EXPECT_TRUE(call.get() == CallOutcome::kGone);
}

class ServiceElsewhere : public testing::Test {
 protected:
  CallResult call(std::chrono::nanoseconds timeout = kDeadline) {
    return node_.call("/s", saying("hello"), reply_, timeout);
  }

  const int domain_ = test::testDomain();
  Transport transport_;
  Node node_ = transport_.node();
  StringMsg reply_;
};

TEST_F(ServiceElsewhere, AnswersAtOnceAndAgain) {
  const auto other = server("echo");
  for (int i = 0; i < 100; ++i) {
    reply_.Clear();
    const CallResult result = call();
    ASSERT_TRUE(result) << result.error;
    ASSERT_EQ(reply_.data(), "hello!");
  }
}

TEST_F(ServiceElsewhere, AnswersEachNewcomer) {
  const auto other = server("echo");
  for (int i = 0; i < 20; ++i) {
    Transport newcomer;
    const CallResult result = newcomer.node().call("/s", saying("hello"), reply_, kDeadline);
    ASSERT_TRUE(result) << result.error;
  }
}

TEST_F(ServiceElsewhere, WarnsOfAWorldOfTheSameName) {
  const auto other = peer({"serve", "/world/w/control", "echo"});
  ASSERT_TRUE(other->waitForOutput("ready")) << other->error();
  const Service control = echo(node_, "/world/w/control");
  EXPECT_TRUE(other->waitForError("process " + std::to_string(getpid()) + " runs a world 'w', too")) << other->error();
}

TEST_F(ServiceElsewhere, IsWaitedFor) {
  auto result = std::async(std::launch::async, [this] { return call(); });
  const auto other = server("echo");
  EXPECT_TRUE(result.get());
  EXPECT_EQ(reply_.data(), "hello!");
}

TEST_F(ServiceElsewhere, AnswersOnlyTheOneWhoAsked) {
  const Service service = echo(node_, "/s");
  const Dispatched dispatched(transport_);
  std::vector<std::unique_ptr<Process>> clients;
  for (int i = 0; i < 4; ++i) clients.push_back(peer({"ask", "/s", "25"}));
  std::string expected;
  for (int i = 0; i < 25; ++i) expected += "answered " + std::to_string(i) + "!\n";
  for (const auto& client : clients) {
    EXPECT_EQ(client->wait(), 0);
    EXPECT_EQ(client->output(), expected);
  }
}

TEST_F(ServiceElsewhere, SurvivesRepliesToOthersWhenAClientEnds) {
  const Service service = echo(node_, "/s");
  const Dispatched dispatched(transport_);
  std::atomic<bool> ended = false;
  std::vector<std::future<void>> others;
  for (int i = 0; i < 3; ++i) {
    others.push_back(std::async(std::launch::async, [&ended] {
      Transport other;
      StringMsg reply;
      while (!ended) EXPECT_TRUE(other.node().call("/s", saying("other"), reply, kDeadline));
    }));
  }
  for (int i = 0; i < 40; ++i) {
    Transport shortLived;
    EXPECT_TRUE(shortLived.node().call("/s", saying("hello"), reply_, kDeadline));
  }
  ended = true;
}

TEST_F(ServiceElsewhere, AsksOneOfSeveralWithTheSameName) {
  const auto first = server("echo");
  const auto second = server("echo");
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(call());
  for (Process* process : {first.get(), second.get()}) {
    process->kill(SIGTERM);
    EXPECT_EQ(process->wait(), 0);
  }
  const std::string asked = first->output() + second->output();
  std::size_t count = 0;
  for (std::size_t at = asked.find("asked"); at != std::string::npos; at = asked.find("asked", at + 1)) ++count;
  EXPECT_EQ(count, 10U);
}

TEST_F(ServiceElsewhere, SaysWhyItRefused) {
  const auto other = server("refuse");
  const CallResult result = call();
  EXPECT_EQ(result.outcome, CallOutcome::kRefused);
  EXPECT_EQ(result.error, "service '/s' refused: not today");
}

TEST_F(ServiceElsewhere, DoesNotHoldUpTheCallerForLongerThanAskedFor) {
  EXPECT_EQ(call(kSoon).outcome, CallOutcome::kNoService);
  const auto other = server("hang");
  // the service is found, or not yet: both end in time
  const CallResult result = call(std::chrono::seconds(2));
  EXPECT_TRUE(result.outcome == CallOutcome::kNoAnswer || result.outcome == CallOutcome::kNoService);
  other->kill(SIGKILL);
}

TEST_F(ServiceElsewhere, SaysThatItDiedBeforeItAnswered) {
  const auto other = server("hang");
  auto result = std::async(std::launch::async, [this] { return call(); });
  ASSERT_TRUE(other->waitForOutput("asked hello"));
  other->kill(SIGKILL);
  const CallResult outcome = result.get();
  EXPECT_EQ(outcome.outcome, CallOutcome::kGone);
  EXPECT_EQ(outcome.error, "service '/s' ended before it answered");
}

TEST_F(ServiceElsewhere, AnswersBeforeItEnds) {
  for (int i = 0; i < 3; ++i) {
    const auto other = server("once");
    const CallResult result = call();
    EXPECT_TRUE(result) << result.error;
    EXPECT_EQ(other->wait(), 0);
  }
}

TEST_F(ServiceElsewhere, SaysThatItHasOtherTypes) {
  const auto other = server("echo");
  Boolean wrong;
  const CallResult result = node_.call("/s", saying(""), wrong, kDeadline);
  EXPECT_EQ(result.outcome, CallOutcome::kOtherTypes);
  EXPECT_EQ(result.error, "service '/s' takes ignition.msgs.StringMsg and returns ignition.msgs.StringMsg");
}

TEST_F(ServiceElsewhere, IsListedWithItsTypesAndAmongNoTopics) {
  const auto other = server("echo");
  const ServiceInfo info = transport_.waitForService("s", kDeadline);
  EXPECT_EQ(info.name, "/s");
  ASSERT_EQ(info.providers.size(), 1U);
  EXPECT_EQ(info.providers[0], (ServiceInfo::Provider{"ignition.msgs.StringMsg", "ignition.msgs.StringMsg",
                                                      static_cast<int>(other->pid())}));
  const std::vector<ServiceInfo> all = transport_.discoverServices(kDeadline);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].name, "/s");
  EXPECT_TRUE(transport_.discover(kDeadline).empty());
}

TEST_F(ServiceElsewhere, DropsADamagedRequestWithAWarningAndGoesOn) {
  const auto other = server("echo");
  transport::Network stranger(std::nullopt);
  const std::string type = transport::serviceType("ignition.msgs.StringMsg", "ignition.msgs.StringMsg");
  auto writer = stranger.makeWriter(transport::requestTopic("/s"), type, nullptr);
  while (!writer->hasReaders()) std::this_thread::yield();
  writer->write(3, [](std::span<std::byte> place) { std::ranges::fill(place, std::byte{0xff}); });
  EXPECT_TRUE(other->waitForError("service '/s': a request from process \\d+ is damaged; dropped")) << other->error();
  stranger.end(std::move(writer));
  EXPECT_TRUE(call());
}

/// Topics that fill a process's first participant.
std::vector<Publisher> manyTopics(Node node) {
  std::vector<Publisher> all;
  for (int i = 0; i < 1000; ++i) all.push_back(node.advertise<StringMsg>("/many/" + std::to_string(i)));
  return all;
}

TEST(Service, AnswersWhereBothProcessesHaveManyTopics) {
  test::testDomain();
  Transport serving, asking;
  const std::vector<Publisher> served = manyTopics(serving.node()), asked = manyTopics(asking.node());
  const Service service = echo(serving.node(), "/s");
  const Dispatched dispatched(serving);
  StringMsg reply;
  EXPECT_TRUE(asking.node().call("/s", saying("hi"), reply, kDeadline));
  EXPECT_EQ(reply.data(), "hi!");
}

}  // namespace
}  // namespace pongsim
