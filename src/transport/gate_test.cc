#include "transport/gate.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "support/process.hh"

namespace pongsim::transport {

namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;
using Words = std::vector<std::string>;
using Wanted = std::vector<std::uint64_t>;

/// A transport with a gate for /a and /b, and one outside.
class GateTest : public testing::Test {
 protected:
  Subscription note(const std::string& topic) {
    return inside_.node().subscribe<Int32>(
        topic, [this, topic](const Int32& message) { heard_.push_back(topic + std::to_string(message.data())); });
  }
  static void send(Publisher& publisher, int value) {
    Int32 message;
    message.set_data(value);
    publisher.publish(message);
  }
  Words takeHeard() { return std::exchange(heard_, {}); }

  Transport inside_{{.network = false, .domain = {}}};
  Transport outside_{inside_, Transport::Sharing()};
  Words heard_;
  Subscription a_ = note("/a"), b_ = note("/b"), other_ = note("/other");
  Gate gate_{inside_, {"/a", "/b"}};
  Publisher toA_ = outside_.node().advertise<Int32>("/a");
  Publisher toB_ = outside_.node().advertise<Int32>("/b");
  Publisher toOther_ = outside_.node().advertise<Int32>("/other");
};

TEST_F(GateTest, TakesInAtTicksOnlyWhatTheyWaitFor) {
  send(toA_, 1);
  send(toA_, 2);
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), Words{});
  EXPECT_FALSE(gate_.isComplete(Wanted{1, 1}));
  send(toB_, 1);
  ASSERT_TRUE(gate_.isComplete(Wanted{1, 1}));
  gate_.pass(Wanted{1, 1});
  EXPECT_EQ(takeHeard(), (Words{"/a1", "/b1"}));
  // between ticks, nothing
  send(toB_, 2);
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), Words{});
  gate_.pass(Wanted{1, 1});
  EXPECT_EQ(takeHeard(), (Words{"/a2", "/b2"}));
  EXPECT_EQ(gate_.waiting(0), 0U);
}

// a controller may be there before the world has its gate
TEST(Gate, CountsWhatCameBeforeIt) {
  Transport inside({.network = false, .domain = {}});
  Transport outside(inside, Transport::Sharing());
  std::vector<int> heard;
  const auto hear = [&heard](const Int32& message) { heard.push_back(message.data()); };
  const Subscription first = inside.node().subscribe<Int32>("/a", hear);
  const Subscription second = inside.node().subscribe<Int32>("/a", hear);
  Publisher publisher = outside.node().advertise<Int32>("/a");
  Int32 message;
  for (const int value : {1, 2}) {
    message.set_data(value);
    publisher.publish(message);
  }
  Gate gate(inside, {"/a"});
  EXPECT_EQ(gate.waiting(0), 2U);
  inside.dispatch();
  EXPECT_EQ(heard, std::vector<int>{});
  gate.pass(Wanted{1});
  EXPECT_EQ(heard, (std::vector{1, 1}));
  EXPECT_EQ(gate.waiting(0), 1U);
}

TEST_F(GateTest, TakesSeveralMessagesAndLeavesTopicsThatAreNotDue) {
  for (const int value : {1, 2, 3}) send(toA_, value);
  send(toB_, 1);
  EXPECT_FALSE(gate_.isComplete(Wanted{4, 0}));
  gate_.pass(Wanted{2, 0});
  EXPECT_EQ(takeHeard(), (Words{"/a1", "/a2"}));
  EXPECT_EQ(gate_.waiting(0), 1U);
  gate_.pass(Wanted{1, 1});
  EXPECT_EQ(takeHeard(), (Words{"/a3", "/b1"}));
}

TEST_F(GateTest, TakesOfOtherTopicsWhatCameBeforeTheLastMessage) {
  send(toOther_, 1);
  send(toA_, 1);
  send(toOther_, 2);
  send(toB_, 1);
  send(toOther_, 3);
  gate_.pass(Wanted{1, 1});
  EXPECT_EQ(takeHeard(), (Words{"/other1", "/a1", "/other2", "/b1"}));
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), Words{});
  send(toA_, 2);
  gate_.pass(Wanted{1, 0});
  EXPECT_EQ(takeHeard(), (Words{"/other3", "/a2"}));
}

TEST_F(GateTest, LetsOwnMessagesPassAndHoldsThoseOfCarriers) {
  Publisher own = inside_.node().advertise<Int32>("/a");
  Publisher carrier = inside_.node().advertise("/a", "ignition.msgs.Int32", {.relays = true});
  send(own, 1);
  send(carrier, 2);
  EXPECT_FALSE(gate_.isComplete(Wanted{2, 0}));
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), Words{"/a1"});
  gate_.pass(Wanted{1, 0});
  EXPECT_EQ(takeHeard(), Words{"/a2"});
}

TEST_F(GateTest, TakesWhatIsThereWhereATickIsNotComplete) {
  send(toA_, 1);
  send(toOther_, 1);
  gate_.pass(Wanted{3, 1});
  EXPECT_EQ(takeHeard(), (Words{"/a1", "/other1"}));
}

TEST_F(GateTest, ForgetsWhatIsDiscarded) {
  send(toA_, 1);
  inside_.discard();
  EXPECT_EQ(gate_.waiting(0), 0U);
  send(toA_, 2);
  gate_.pass(Wanted{1, 0});
  EXPECT_EQ(takeHeard(), Words{"/a2"});
}

TEST_F(GateTest, HandlesRequestsThatComeBeforeATickIsCompleteAndNoMessages) {
  const Service service =
      inside_.node().serve<StringMsg, StringMsg>("/note", [this](const StringMsg& request, StringMsg&) {
        heard_.push_back(request.data());
        return true;
      });
  std::vector<std::thread> callers;
  const auto call = [&](const std::string& text) {
    callers.emplace_back([this, text] {
      StringMsg request, reply;
      request.set_data(text);
      EXPECT_TRUE(outside_.node().call("/note", request, reply, test::kDeadline));
    });
  };
  send(toA_, 1);
  call("early");
  while (heard_.empty()) {
    gate_.wait(Wanted{1, 1}, test::kDeadline);
    gate_.serve(Wanted{1, 1});
  }
  EXPECT_EQ(takeHeard(), Words{"early"});
  // what systems request is never held
  StringMsg own;
  own.set_data("own");
  const PendingRequest pending = inside_.node().request("/note", own, "ignition.msgs.StringMsg", {});
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), Words{"own"});
  send(toB_, 1);
  call("late");
  gate_.wait(Wanted{9, 9}, test::kDeadline);
  gate_.serve(Wanted{1, 1});
  gate_.pass(Wanted{1, 1});
  inside_.dispatch();
  EXPECT_EQ(takeHeard(), (Words{"/a1", "/b1"}));
  // the next tick, or a pause, has it
  gate_.setPaused(true);
  while (heard_.empty()) inside_.dispatchFor(test::kDeadline);
  EXPECT_EQ(takeHeard(), Words{"late"});
  for (std::thread& caller : callers) caller.join();
}

TEST_F(GateTest, SaysWhoIsThere) {
  EXPECT_FALSE(gate_.isHeard(""));
  EXPECT_EQ(gate_.publishers("/a"), "this process");
  EXPECT_EQ(gate_.publishers("/nobody"), "");
  const Publisher told = inside_.node().advertise<Int32>("/told");
  EXPECT_FALSE(gate_.isHeard("/told"));
  const Subscription hears = outside_.node().subscribe<Int32>("/told", [](const Int32&) {});
  EXPECT_TRUE(gate_.isHeard("told"));
  EXPECT_TRUE(gate_.isHeard(""));
  EXPECT_FALSE(gate_.isHeard("/a"));
}

TEST_F(GateTest, IsWokenByAnotherThread) {
  // which handles what the gate's beginning has left
  gate_.serve(Wanted{1, 1});
  std::thread other([this] { inside_.node().wake(); });
  EXPECT_TRUE(gate_.wait(Wanted{1, 1}, test::kDeadline));
  other.join();
}

}  // namespace
}  // namespace pongsim::transport
