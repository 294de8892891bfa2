// Several transports that share one network, each with a queue of its own.
#include "transport/dispatch_queue.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::dispatch_queue_test {
namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;
using Texts = std::vector<std::string>;

StringMsg textOf(const std::string& content) {
  StringMsg message;
  message.set_data(content);
  return message;
}

class DispatchQueue : public testing::Test {
 protected:
  static Subscription hear(Transport& transport, Texts& heard) {
    return transport.node().subscribe<StringMsg>(
        "/chatter", [&heard](const StringMsg& message) { heard.push_back(message.data()); });
  }
  static Subscription hearAtOnce(Transport& transport, Texts& heard) {
    return transport.node().subscribeAtOnce("/chatter", "ignition.msgs.StringMsg",
                                            [&heard](const Message& message, const Bulk*) {
                                              heard.push_back(static_cast<const StringMsg&>(message).data());
                                            });
  }
  /// A service that responds with its name.
  static Service answer(Transport& transport, const std::string& name) {
    return transport.node().serve<StringMsg, StringMsg>("/who", [name](const StringMsg&, StringMsg& reply) {
      reply.set_data(name);
      return true;
    });
  }
  static PendingRequest ask(Transport& transport, Texts& answers) {
    return transport.node().request(
        "/who", StringMsg(), "ignition.msgs.StringMsg", [&answers](const CallResult& result, const Message& reply) {
          answers.push_back(result ? static_cast<const StringMsg&>(reply).data() : result.error);
        });
  }

  Transport first_{{.network = false}};
  Transport second_{first_, Transport::Sharing()};
};

TEST_F(DispatchQueue, HandsOverWhatIsForItsOwnSubscriptionsAlone) {
  Texts one, two;
  const Subscription inFirst = hear(first_, one), inSecond = hear(second_, two);
  Publisher publisher = first_.node().advertise<StringMsg>("/chatter");
  EXPECT_TRUE(publisher.hasSubscribers());
  publisher.publish(textOf("a"));
  EXPECT_EQ(first_.dispatch(), 1U);
  EXPECT_EQ(one, Texts{"a"});
  EXPECT_EQ(two, Texts{});
  EXPECT_EQ(second_.dispatch(), 1U);
  EXPECT_EQ(two, Texts{"a"});
  EXPECT_EQ(first_.dispatch() + second_.dispatch(), 0U);
}

TEST_F(DispatchQueue, KnowsTheTopicsOfItsOwnTransportAlone) {
  const std::uint64_t before = second_.node().ownTopicsVersion();
  const Publisher publisher = first_.node().advertise<StringMsg>("/chatter");
  EXPECT_EQ(second_.node().ownTopicsVersion(), before);
  Texts heard;
  const Subscription subscription = hear(second_, heard);
  EXPECT_NE(second_.node().ownTopicsVersion(), before);
  EXPECT_EQ(first_.node().ownTopics(), (std::vector<OwnTopic>{{"/chatter", "ignition.msgs.StringMsg", 1, 0, false}}));
  EXPECT_EQ(second_.node().ownTopics(), (std::vector<OwnTopic>{{"/chatter", "ignition.msgs.StringMsg", 0, 1, false}}));
}

// otherwise a world would be called on another one's thread
TEST_F(DispatchQueue, HearsAtOnceWhatItsOwnTransportPublishes) {
  Texts heard, other;
  const Subscription atOnce = hearAtOnce(second_, heard);
  Publisher own = second_.node().advertise<StringMsg>("/chatter");
  Publisher foreign = first_.node().advertise<StringMsg>("/chatter");
  own.publish(textOf("own"));
  EXPECT_EQ(heard, Texts{"own"});
  foreign.publish(textOf("foreign"));
  EXPECT_EQ(heard, Texts{"own"});
  EXPECT_EQ(second_.dispatch(), 1U);
  EXPECT_EQ(heard, (Texts{"own", "foreign"}));
  EXPECT_EQ(second_.dispatch(), 0U);
  {
    const Subscription inFirst = hearAtOnce(first_, other);
    own.publish(textOf("both"));
    EXPECT_EQ(heard.back(), "both");
    EXPECT_EQ(first_.dispatch(), 1U);
    EXPECT_EQ(other, Texts{"both"});
    EXPECT_EQ(second_.dispatch(), 0U);
  }
  foreign.publish(textOf("last"));
  EXPECT_EQ(second_.dispatch(), 1U);
  EXPECT_EQ(heard.back(), "last");
}

TEST_F(DispatchQueue, GivesWhatIsLatchedToSubscriptionsOfOthers) {
  Publisher publisher = first_.node().advertise<StringMsg>("/chatter", {.latched = true});
  publisher.publish(textOf("kept"));
  Texts heard;
  const Subscription subscription = hear(second_, heard);
  EXPECT_EQ(second_.dispatch(), 1U);
  EXPECT_EQ(heard, Texts{"kept"});
}

TEST_F(DispatchQueue, LetsEachCallItsOwnServiceOfAName) {
  testing::internal::CaptureStderr();
  Service inFirst = answer(first_, "first");
  const Service inSecond = answer(second_, "second");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: transport: service '/who' is also offered by another world of this process: callers in other "
            "processes get the reply of the first\n");
  EXPECT_THROW(answer(second_, "again"), std::invalid_argument);

  Transport third(first_, Transport::Sharing());
  Texts ofFirst, ofSecond, ofThird;
  const PendingRequest one = ask(first_, ofFirst), two = ask(second_, ofSecond), three = ask(third, ofThird);
  second_.dispatch();
  EXPECT_EQ(ofSecond, Texts{"second"});
  first_.dispatch();
  EXPECT_EQ(ofFirst, Texts{"first"});
  third.dispatch();
  EXPECT_EQ(ofThird, Texts{"first"});

  inFirst = Service();
  const PendingRequest again = ask(third, ofThird);
  second_.dispatch();
  third.dispatch();
  EXPECT_EQ(ofThird.back(), "second");
}

TEST_F(DispatchQueue, TellsTheFirstThatSharesOfWhatIsThereOnce) {
  const auto serve = [](Transport& transport, const std::string& name) {
    return transport.node().serve<StringMsg, StringMsg>(name, [](const StringMsg&, StringMsg&) { return true; });
  };
  const auto names = [](const Node& node) {
    Texts all;
    for (const OwnService& service : node.ownServices()) all.push_back(service.name);
    return all;
  };
  Transport third(first_, Transport::Sharing());
  Service once = serve(first_, "/once");
  const Service own = serve(second_, "/own");
  EXPECT_EQ(names(first_.node()), Texts{"/once"});
  EXPECT_EQ(names(second_.node()), (Texts{"/once", "/own"}));
  EXPECT_EQ(names(third.node()), Texts{});
  once = {};
  EXPECT_EQ(names(second_.node()), Texts{"/own"});
}

TEST_F(DispatchQueue, AnswersWhereTheRequestCameFrom) {
  Service service = answer(first_, "first");
  Texts answers;
  const PendingRequest kept = ask(second_, answers);
  PendingRequest dropped = ask(second_, answers);
  first_.dispatch();
  EXPECT_EQ(answers, Texts{});
  dropped = PendingRequest();
  EXPECT_EQ(second_.dispatch(), 1U);
  EXPECT_EQ(answers, Texts{"first"});

  const PendingRequest unanswered = ask(second_, answers);
  service = Service();
  EXPECT_EQ(answers.size(), 1U);
  second_.dispatch();
  EXPECT_EQ(answers.back(), "service '/who' ended before it answered");
}

TEST_F(DispatchQueue, IsWokenAlone) {
  std::atomic<bool> isBack = false;
  std::thread waiting([&] {
    second_.dispatchFor(test::kDeadline);
    isBack = true;
  });
  first_.wake();
  EXPECT_EQ(first_.dispatchFor(test::kDeadline), 0U);
  second_.wake();
  waiting.join();
  EXPECT_TRUE(isBack);
}

TEST_F(DispatchQueue, IsForAThreadOfItsOwn) {
  constexpr int kCount = 20000;
  const auto work = [](Transport& transport, const std::string& says, const std::string& hears, int& sum) {
    // makes and ends subscriptions while the other one dispatches
    const Subscription subscription = transport.node().subscribe<Int32>(
        hears, [&sum](const Int32& message) { sum += message.data(); }, {.queueLength = kCount});
    Publisher publisher = transport.node().advertise<Int32>(says);
    publisher.waitForSubscribers(test::kDeadline);
    Int32 one;
    one.set_data(1);
    for (int i = 0; i < kCount; ++i) {
      publisher.publish(one);
      transport.dispatch();
      const Subscription passing = transport.node().subscribe<Int32>(hears, [](const Int32&) {});
    }
    while (sum < kCount) transport.dispatchFor(test::kDeadline);
  };
  int ofFirst = 0, ofSecond = 0;
  std::thread thread([&] { work(second_, "/b", "/a", ofSecond); });
  work(first_, "/a", "/b", ofFirst);
  thread.join();
  EXPECT_EQ(ofFirst, kCount);
  EXPECT_EQ(ofSecond, kCount);
}

TEST(DispatchQueueOfAProcess, OpensTheNextServiceOfANameToOthers) {
  test::testDomain();
  Transport first, second(first, Transport::Sharing()), other;
  const auto offer = [](Transport& transport, const std::string& name) {
    return transport.node().serve<StringMsg, StringMsg>("/who", [name](const StringMsg&, StringMsg& reply) {
      reply.set_data(name);
      return true;
    });
  };
  Service inFirst = offer(first, "first");
  const Service inSecond = offer(second, "second");
  std::atomic<bool> isOver = false;
  std::thread dispatching([&] {
    while (!isOver) {
      first.dispatch();
      second.dispatchFor(std::chrono::milliseconds(1));
    }
  });
  // not for long: a request that is sent while the first one ends has no answer
  const auto call = [&other] {
    StringMsg reply;
    return other.node().call("/who", StringMsg(), reply, std::chrono::milliseconds(500)) ? reply.data() : std::string();
  };
  EXPECT_TRUE(test::waitUntil([&] { return call() == "first"; }));
  inFirst = Service();
  EXPECT_TRUE(test::waitUntil([&] { return call() == "second"; }));
  isOver = true;
  dispatching.join();
}

TEST_F(DispatchQueue, DiscardsMessagesButLatchedOnes) {
  Texts heard;
  const Subscription hearing = hear(first_, heard);
  Publisher once = first_.node().advertise<StringMsg>("/chatter");
  Publisher latched = first_.node().advertise<StringMsg>("/chatter", {.latched = true});
  once.publish(textOf("a"));
  latched.publish(textOf("old"));
  latched.publish(textOf("kept"));
  once.publish(textOf("b"));
  first_.discard();
  once.publish(textOf("c"));
  EXPECT_EQ(first_.dispatch(), 2U);
  EXPECT_EQ(heard, (Texts{"kept", "c"}));
  first_.discard();
  EXPECT_EQ(first_.dispatch(), 0U);
}

TEST_F(DispatchQueue, DiscardsRequestsAndTellsWhoMadeThem) {
  Texts answers;
  const Service service = answer(first_, "first");
  const PendingRequest request = ask(first_, answers);
  first_.discard();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_NE(answers[0].find("/who"), std::string::npos);
  EXPECT_EQ(first_.dispatch(), 0U);
  const PendingRequest next = ask(first_, answers);
  first_.dispatch();
  EXPECT_EQ(answers.back(), "first");
}

TEST_F(DispatchQueue, TellsWhyAMessageWouldBeRefused) {
  using ignition::msgs::Double;
  const auto refusal = [this](double number) {
    Double message;
    message.set_data(number);
    return first_.node().refusal("speed", message);
  };
  EXPECT_EQ(refusal(NAN), std::nullopt);
  const Subscription hearing = first_.node().subscribe<Double>("/speed", [](const Double&) {}, {.largestNumber = 10});
  EXPECT_EQ(refusal(10), std::nullopt);
  for (const double bad : {11.0, double{NAN}, double{INFINITY}}) {
    ASSERT_TRUE(refusal(bad)) << bad;
    EXPECT_NE(refusal(bad)->find("data"), std::string::npos) << *refusal(bad);
  }
  // a subscription of another transport is not this one's
  EXPECT_EQ(second_.node().refusal("speed", Double()), std::nullopt);
}

}  // namespace
}  // namespace pongsim::dispatch_queue_test
