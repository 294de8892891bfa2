#include "transport/bus.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/node.hh"
#include "support/process.hh"

namespace pongsim {

namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;

class BusTest : public testing::Test {
 protected:
  Int32 number(int value) {
    Int32 message;
    message.set_data(value);
    return message;
  }

  std::function<void(const Int32&)> noteAs(const std::string& who) {
    return [this, who](const Int32& message) { heard_.push_back(who + std::to_string(message.data())); };
  }

  Transport transport_{{.network = false, .domain = {}}};
  Node node_ = transport_.node();
  std::vector<std::string> heard_;
};

using Words = std::vector<std::string>;

}  // namespace

TEST_F(BusTest, HandsOverInTheOrderOfPublishingOverAllTopics) {
  Publisher a = node_.advertise<Int32>("/a");
  Publisher b = node_.advertise<Int32>("b");
  Subscription first = node_.subscribe<Int32>("/b", noteAs("b"));
  Subscription second = node_.subscribe<Int32>("a", noteAs("a"));
  Subscription third = node_.subscribe<Int32>("/a", noteAs("A"));
  a.publish(number(1));
  b.publish(number(2));
  a.publish(number(3));
  EXPECT_TRUE(heard_.empty());
  EXPECT_EQ(transport_.dispatch(), 5);
  EXPECT_EQ(heard_, (Words{"a1", "A1", "b2", "a3", "A3"}));
  EXPECT_EQ(transport_.dispatch(), 0);
}

TEST_F(BusTest, KeepsWhatIsPublishedDuringADispatchForTheNext) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription sub = node_.subscribe<Int32>("/a", [&](const Int32& message) {
    heard_.push_back(std::to_string(message.data()));
    if (message.data() < 3) a.publish(number(message.data() + 1));
  });
  a.publish(number(1));
  EXPECT_EQ(transport_.dispatch(), 1);
  EXPECT_EQ(heard_, (Words{"1"}));
  EXPECT_EQ(transport_.dispatch(), 1);
  EXPECT_EQ(transport_.dispatch(), 1);
  EXPECT_EQ(transport_.dispatch(), 0);
  EXPECT_EQ(heard_, (Words{"1", "2", "3"}));
}

TEST_F(BusTest, DropsTheOldestAndCounts) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription sub = node_.subscribe<Int32>("/a", noteAs(""), {.queueLength = 2});
  for (int i = 0; i < 5; ++i) a.publish(number(i));
  EXPECT_EQ(sub.dropped(), 3);
  EXPECT_EQ(sub.received(), 2);
  EXPECT_EQ(a.sent(), 5);
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"3", "4"}));
}

TEST_F(BusTest, GivesWhatIsLatchedToWhoComesLater) {
  Publisher latched = node_.advertise<Int32>("/a", {.latched = true});
  Publisher plain = node_.advertise<Int32>("/a");
  latched.publish(number(1));
  latched.publish(number(2));
  plain.publish(number(3));
  EXPECT_EQ(plain.sent(), 0) << "nobody listens";
  Subscription first = node_.subscribe<Int32>("/a", noteAs("a"));
  EXPECT_EQ(transport_.dispatch(), 1);
  Subscription second = node_.subscribe<Int32>("/a", noteAs("b"));
  EXPECT_EQ(transport_.dispatchFor(test::kDeadline), 1);
  EXPECT_EQ(heard_, (Words{"a2", "b2"}));
  latched = Publisher();
  Subscription third = node_.subscribe<Int32>("/a", noteAs("c"));
  EXPECT_EQ(transport_.dispatch(), 0);
}

TEST_F(BusTest, SharesAMessageAmongItsSubscriptions) {
  Publisher a = node_.advertise<Int32>("/a");
  std::vector<const Int32*> heard;
  const auto note = [&heard](const Int32& message) { heard.push_back(&message); };
  const Subscription first = node_.subscribe<Int32>("/a", note);
  const Subscription second = node_.subscribe<Int32>("/a", note);
  Int32 message = number(1);
  a.publish(message);
  message.set_data(2);
  transport_.dispatch();
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0], heard[1]);
  EXPECT_NE(heard[0], &message);
  EXPECT_EQ(heard[0]->data(), 1) << "the publisher may change its own";
  a.publish(message);
  transport_.dispatch();
  EXPECT_EQ(heard[2], heard[0]) << "its memory is used again";
}

TEST_F(BusTest, CarriesBytes) {
  std::vector<std::string> bytes;
  const auto note = [&bytes](std::span<const std::byte> each) {
    bytes.emplace_back(reinterpret_cast<const char*>(each.data()), each.size());
  };
  const Subscription raw = node_.subscribeBytes("/a", "gz.msgs.Int32", note);
  const Subscription typed = node_.subscribe<Int32>("/a", noteAs("a"));
  const Subscription unknown = node_.subscribeBytes("/b", "acme.Rocket", note);
  node_.advertise<Int32>("/a").publish(number(7));
  transport_.dispatch();
  ASSERT_EQ(bytes, Words{number(7).SerializeAsString()});

  const std::string eight = number(8).SerializeAsString();
  node_.advertiseBytes("/a", "Int32").publishBytes(std::as_bytes(std::span(eight)));
  node_.advertiseBytes("/b", "acme.Rocket").publishBytes(std::as_bytes(std::span("?", 1)));
  transport_.dispatch();
  EXPECT_EQ(bytes, (Words{number(7).SerializeAsString(), eight, "?"}));
  EXPECT_EQ(heard_, (Words{"a7", "a8"}));

  const std::string broken(3, '\xff');
  testing::internal::CaptureStderr();
  node_.advertiseBytes("/a", "Int32").publishBytes(std::as_bytes(std::span(broken)));
  EXPECT_EQ(transport_.dispatch(), 1);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("a message from this process is not of type ignition.msgs.Int32"), std::string::npos) << said;
  EXPECT_THROW(node_.advertiseBytes("/a", ""), std::invalid_argument);
}

TEST_F(BusTest, KnowsWhetherSomebodyListens) {
  Publisher a = node_.advertise<Int32>("/a");
  EXPECT_FALSE(a.hasSubscribers());
  EXPECT_FALSE(a.waitForSubscribers(std::chrono::nanoseconds(0)));
  {
    const Subscription sub = node_.subscribe<Int32>("/a", noteAs(""));
    EXPECT_TRUE(a.hasSubscribers());
    EXPECT_TRUE(a.waitForSubscribers(std::chrono::nanoseconds::max()));
  }
  EXPECT_FALSE(a.hasSubscribers());
  EXPECT_TRUE(a.waitForDelivery(std::chrono::nanoseconds(0)));
}

TEST_F(BusTest, CallsNothingOnceASubscriptionHasEnded) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription first;
  Subscription second;
  first = node_.subscribe<Int32>("/a", [&](const Int32&) {
    heard_.push_back("first");
    first = Subscription();
    second = Subscription();
  });
  second = node_.subscribe<Int32>("/a", noteAs("second"));
  a.publish(number(1));
  a.publish(number(2));
  EXPECT_EQ(transport_.dispatch(), 1);
  EXPECT_EQ(heard_, (Words{"first"}));

  Subscription third = node_.subscribe<Int32>("/a", noteAs("third"));
  a.publish(number(3));
  third = Subscription();
  EXPECT_EQ(transport_.dispatch(), 0);
}

TEST_F(BusTest, TakesNewSubscriptionsDuringADispatch) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription later;
  Subscription sub = node_.subscribe<Int32>("/a", [&](const Int32&) {
    if (!later) later = node_.subscribe<Int32>("/a", noteAs("later"));
  });
  a.publish(number(1));
  transport_.dispatch();
  EXPECT_TRUE(heard_.empty());
  a.publish(number(2));
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"later2"}));
}

TEST_F(BusTest, GoesOnAfterAFunctionThatThrew) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription sub = node_.subscribe<Int32>("/a", [&](const Int32& message) {
    if (message.data() == 1) throw std::runtime_error("no");
    heard_.push_back("heard");
  });
  a.publish(number(1));
  EXPECT_THROW(transport_.dispatch(), std::runtime_error);
  a.publish(number(2));
  EXPECT_EQ(transport_.dispatch(), 1);
  EXPECT_EQ(heard_, (Words{"heard"}));
}

TEST_F(BusTest, CallsTheOtherFunctionsWhereOneThrows) {
  Publisher a = node_.advertise<Int32>("/a");
  const Subscription failing = node_.subscribe<Int32>(
      "/a", [](const Int32& message) { throw std::runtime_error("no " + std::to_string(message.data())); });
  const Subscription other = node_.subscribe<Int32>("/a", noteAs(""));
  const Service service = node_.serve<Int32, Int32>("/double", [](const Int32&, Int32&) { return true; });
  int answers = 0;
  const auto answered = [&answers](const CallResult&, const Message&) {
    ++answers;
    throw std::runtime_error("the answer is no good");
  };
  const PendingRequest first = node_.request("/double", number(1), "ignition.msgs.Int32", answered);
  const PendingRequest second = node_.request("/double", number(2), "ignition.msgs.Int32", answered);
  a.publish(number(1));
  a.publish(number(2));
  std::string thrown;
  try {
    transport_.dispatch();
  } catch (const std::exception& error) {
    thrown = error.what();
  }
  EXPECT_EQ(thrown, "no 1");
  EXPECT_EQ(heard_, (Words{"1", "2"}));
  EXPECT_EQ(answers, 2);
  EXPECT_EQ(failing.received() + failing.dropped(), 2);
  EXPECT_EQ(transport_.dispatch(), 0);
}

TEST_F(BusTest, RefusesADispatchWithinADispatch) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription sub = node_.subscribe<Int32>("/a", [&](const Int32&) {
    a.publish(number(2));
    EXPECT_THROW(transport_.dispatch(), std::logic_error);
  });
  a.publish(number(1));
  transport_.dispatch();
}

TEST_F(BusTest, KeepsTypesApart) {
  Publisher a = node_.advertise<Int32>("/a");
  Subscription sub = node_.subscribe<StringMsg>("/a", [](const StringMsg&) { FAIL(); });
  EXPECT_FALSE(a.hasSubscribers());
  a.publish(number(1));
  EXPECT_EQ(transport_.dispatch(), 0);
  EXPECT_THROW(a.publish(StringMsg()), std::invalid_argument);
}

TEST_F(BusTest, PutsRelativeNamesIntoTheNodesNamespace) {
  Node robot = node_.within("fleet").within("robot/");
  Publisher relative = robot.advertise<Int32>("scan");
  Publisher absolute = robot.advertise<Int32>("/scan");
  const Subscription within = node_.subscribe<Int32>("/fleet/robot/scan", noteAs("r"));
  const Subscription outside = node_.subscribe<Int32>("scan", noteAs("a"));
  relative.publish(number(1));
  absolute.publish(number(2));
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"r1", "a2"}));
  EXPECT_THROW(node_.within("a b"), std::invalid_argument);
  EXPECT_THROW(node_.within(""), std::invalid_argument);
  EXPECT_THROW(robot.advertise<Int32>(""), std::invalid_argument);
}

TEST_F(BusTest, PutsAbsoluteNamesIntoANamespaceThatHoldsAll) {
  Node robot = node_.below("robot");
  Publisher relative = robot.advertise<Int32>("scan");
  Publisher absolute = robot.advertise<Int32>("/cmd");
  Publisher whole = robot.advertise<Int32>("/robot/odom");
  EXPECT_EQ(node_.ownTopics().size(), 3U);
  const Subscription scan = node_.subscribe<Int32>("/robot/scan", noteAs("s"));
  const Subscription command = node_.subscribe<Int32>("/robot/cmd", noteAs("c"));
  const Subscription odom = node_.subscribe<Int32>("/robot/odom", noteAs("o"));
  relative.publish(number(1));
  absolute.publish(number(2));
  whole.publish(number(3));
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"s1", "c2", "o3"}));
  EXPECT_THROW(node_.below("a b"), std::invalid_argument);
}

TEST_F(BusTest, RefusesBadNamesAndUnknownTypes) {
  EXPECT_THROW(node_.advertise("/a b", "ignition.msgs.Int32"), std::invalid_argument);
  EXPECT_THROW(node_.subscribe("/a", "ignition.msgs.Nonsense", [](const Message&) {}), std::invalid_argument);
  EXPECT_NO_THROW(node_.advertise("/a", "gz.msgs.Int32"));
}

TEST_F(BusTest, TakesMessagesFromManyThreads) {
  constexpr int kThreads = 4;
  constexpr int kMessages = 500;
  std::vector<int> last(kThreads, -1);
  Subscription sub = node_.subscribe<Int32>("/a", [&](const Int32& message) {
    int& previous = last[static_cast<std::size_t>(message.data() / kMessages)];
    EXPECT_GT(message.data() % kMessages, previous);
    previous = message.data() % kMessages;
  });
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      Publisher publisher = node_.advertise<Int32>("/a");
      for (int j = 0; j < kMessages; ++j) publisher.publish(number(i * kMessages + j));
    });
  }
  std::size_t heard = 0;
  const auto deadline = std::chrono::steady_clock::now() + test::kDeadline;
  while (heard + sub.dropped() < kThreads * kMessages && std::chrono::steady_clock::now() < deadline) {
    heard += transport_.dispatchFor(std::chrono::milliseconds(10));
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(heard + sub.dropped(), kThreads * kMessages);
}

TEST_F(BusTest, IsWokenFromAnotherThread) {
  std::thread other([this] { transport_.wake(); });
  EXPECT_EQ(transport_.dispatchFor(test::kDeadline), 0);
  other.join();
  std::thread byNode([this] { node_.wake(); });
  EXPECT_EQ(transport_.dispatchFor(test::kDeadline), 0);
  byNode.join();
}

TEST_F(BusTest, FindsNothingElsewhereWithoutANetwork) {
  Publisher a = node_.advertise<Int32>("/a");
  EXPECT_TRUE(transport_.discover(test::kDeadline).empty());
  EXPECT_TRUE(transport_.waitForTopic("/a", true, test::kDeadline).publishers.empty());
}

}  // namespace pongsim
