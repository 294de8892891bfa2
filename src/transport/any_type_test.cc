#include "transport/any_type.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/log.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim {

namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;
using test::kDeadline;
using Words = std::vector<std::string>;

template <class M>
M messageOf(const auto& data) {
  M message;
  message.set_data(data);
  return message;
}

/// @return "String:hello" or "Int:3".
std::string wordsOf(std::string_view type, std::span<const std::byte> bytes) {
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (StringMsg message; type == "ignition.msgs.StringMsg" && message.ParseFromString(text)) {
    return "String:" + message.data();
  }
  if (Int32 message; type == "ignition.msgs.Int32" && message.ParseFromString(text)) {
    return "Int:" + std::to_string(message.data());
  }
  return std::string(type);
}

Subscription hear(Node node, Words& heard, const SubscriptionOptions& options = {}) {
  return node.subscribeAnyType(
      "/chatter", [&heard](auto type, auto bytes) { heard.push_back(wordsOf(type, bytes)); }, options);
}

class AnyTypeHere : public testing::Test {
 protected:
  Transport transport_{{.network = false}};
  Node node_ = transport_.node();
  Words heard_;
};

class AnyTypeElsewhere : public testing::Test {
 protected:
  bool dispatchUntil(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    while (!done() && std::chrono::steady_clock::now() < deadline) {
      transport_.dispatchFor(std::chrono::milliseconds(20));
    }
    return done();
  }

  /// @return What this process sees of the topic of the other transport once it is as wanted.
  TopicInfo chatterWhere(Transport& watcher, const std::function<bool(const TopicInfo&)>& isWanted) {
    TopicInfo topic;
    dispatchUntil([&] { return isWanted(topic = watcher.waitForTopic("/chatter", false, {})); });
    return topic;
  }

  const int domain_ = test::testDomain();
  Transport transport_;
  Words heard_;
};

}  // namespace

TEST_F(AnyTypeHere, HearsEachTypeInTheOrderOfPublishing) {
  Publisher before = node_.advertise<StringMsg>("/chatter");
  const Subscription subscription = hear(node_, heard_);
  Publisher after = node_.advertise<Int32>("/chatter");
  Publisher aside = node_.advertise<Int32>("/elsewhere");
  EXPECT_TRUE(before.hasSubscribers());
  EXPECT_TRUE(after.hasSubscribers());
  EXPECT_FALSE(aside.hasSubscribers());
  after.publish(messageOf<Int32>(1));
  before.publish(messageOf<StringMsg>("hello"));
  after.publish(messageOf<Int32>(2));
  EXPECT_TRUE(heard_.empty());
  EXPECT_EQ(transport_.dispatch(), 3U);
  EXPECT_EQ(heard_, (Words{"Int:1", "String:hello", "Int:2"}));
  EXPECT_EQ(subscription.received(), 3U);
}

TEST_F(AnyTypeHere, HearsATypeThatNobodyKnows) {
  const Subscription subscription = hear(node_, heard_);
  Publisher publisher = node_.advertiseBytes("/chatter", "acme.Parcel");
  publisher.publishBytes({});
  transport_.dispatch();
  EXPECT_EQ(heard_, Words{"acme.Parcel"});
}

TEST_F(AnyTypeHere, HearsAPublisherThatComesAgain) {
  const Subscription subscription = hear(node_, heard_);
  for (int i = 0; i < 2; ++i) node_.advertise<Int32>("/chatter").publish(messageOf<Int32>(i));
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"Int:0", "Int:1"}));
}

TEST_F(AnyTypeHere, GetsWhatIsLatched) {
  Publisher publisher = node_.advertise<Int32>("/chatter", {.latched = true});
  publisher.publish(messageOf<Int32>(7));
  const Subscription subscription = hear(node_, heard_);
  transport_.dispatch();
  EXPECT_EQ(heard_, Words{"Int:7"});
}

TEST_F(AnyTypeHere, HearsNothingFromItsEndOn) {
  Publisher publisher = node_.advertise<Int32>("/chatter");
  Subscription subscription = hear(node_, heard_);
  publisher.publish(messageOf<Int32>(1));
  subscription = {};
  transport_.dispatch();
  EXPECT_TRUE(heard_.empty());
  EXPECT_FALSE(publisher.hasSubscribers());
}

TEST_F(AnyTypeHere, MayEndInItsOwnFunction) {
  Publisher publisher = node_.advertise<Int32>("/chatter");
  Subscription subscription;
  subscription = node_.subscribeAnyType("/chatter", [&](auto type, auto bytes) {
    subscription = {};
    heard_.push_back(wordsOf(type, bytes));
  });
  for (int i = 1; i < 4; ++i) publisher.publish(messageOf<Int32>(i));
  transport_.dispatch();
  EXPECT_EQ(heard_, Words{"Int:1"});
}

TEST_F(AnyTypeHere, LeavesOutAPublisherAndCountsWhatItDrops) {
  Publisher own = node_.advertise<Int32>("/chatter"), other = node_.advertise<Int32>("/chatter");
  const Subscription subscription = hear(node_, heard_, {.queueLength = 2, .except = &own});
  own.publish(messageOf<Int32>(0));
  for (int i = 1; i < 4; ++i) other.publish(messageOf<Int32>(i));
  transport_.dispatch();
  EXPECT_EQ(heard_, (Words{"Int:2", "Int:3"}));
  EXPECT_EQ(subscription.dropped(), 1U);
}

TEST_F(AnyTypeHere, TakesNoTypesWithoutEnd) {
  const Subscription subscription = hear(node_, heard_);
  std::vector<Publisher> publishers;
  for (int i = 0; i < 70; ++i) publishers.push_back(node_.advertiseBytes("/chatter", "acme.T" + std::to_string(i)));
  EXPECT_EQ(std::ranges::count_if(publishers, &Publisher::hasSubscribers), 64);
}

TEST_F(AnyTypeHere, RefusesABadName) {
  EXPECT_THROW(node_.subscribeAnyType("a b", [](auto, auto) {}), std::invalid_argument);
}

TEST_F(AnyTypeElsewhere, HearsAnotherProcessThatComesLater) {
  const Subscription subscription = hear(transport_.node(), heard_);
  test::Process other({TRANSPORT_PEER, "say", "/chatter", "3", "0"});
  EXPECT_TRUE(dispatchUntil([&] { return heard_.size() >= 3; }));
  EXPECT_EQ(heard_, (Words{"String:0", "String:1", "String:2"}));
  EXPECT_EQ(other.wait(), 0);
}

TEST_F(AnyTypeElsewhere, HearsAnotherProcessThatWasThereBefore) {
  test::Process other({TRANSPORT_PEER, "latch", "/chatter", "hello"});
  ASSERT_TRUE(other.waitForOutput("ready"));
  ASSERT_FALSE(transport_.waitForTopic("/chatter", true, kDeadline).publishers.empty());
  const Subscription subscription = hear(transport_.node(), heard_);
  EXPECT_TRUE(dispatchUntil([&] { return !heard_.empty(); }));
  EXPECT_EQ(heard_, Words{"String:hello"});
}

TEST_F(AnyTypeElsewhere, IsSeenAsASubscriberOfWhatItHasMet) {
  Transport other;
  Subscription subscription = hear(transport_.node(), heard_);
  const TopicInfo atFirst = chatterWhere(other, [](const TopicInfo& topic) { return !topic.subscribers.empty(); });
  ASSERT_EQ(atFirst.subscribers.size(), 1U);
  EXPECT_EQ(atFirst.subscribers[0].type, "*");

  Publisher texts = other.node().advertise<StringMsg>("/chatter"), numbers = other.node().advertise<Int32>("/chatter");
  EXPECT_TRUE(dispatchUntil([&] { return texts.hasSubscribers() && numbers.hasSubscribers(); }));
  const TopicInfo met = chatterWhere(other, [](const TopicInfo& topic) {
    return topic.subscribers.size() == 2 && topic.subscribers[0].type != "*" && topic.subscribers[1].type != "*";
  });
  EXPECT_EQ(met.subscribers.size(), 2U);

  subscription = {};
  EXPECT_TRUE(
      chatterWhere(other, [](const TopicInfo& topic) { return topic.subscribers.empty(); }).subscribers.empty());
}

}  // namespace pongsim
