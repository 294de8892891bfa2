// What a node does where memory for an endpoint fails: it has the endpoint, or nothing of it is left.
#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/node.hh"
#include "support/failing_allocations.hh"

namespace pongsim {
namespace {

using ignition::msgs::Int32;

Int32 number(int value) {
  Int32 message;
  message.set_data(value);
  return message;
}

class NodeMemoryTest : public testing::Test {
 protected:
  /// All endpoints once: protobuf does not survive a failure when it sets up a type.
  void SetUp() override {
    Publisher publisher = node_.advertise<Int32>("/first");
    const Subscription subscription = node_.subscribe<Int32>("/first", [](const Int32&) {});
    publisher.publish(number(0));
    transport_.dispatch();
    const Service service = node_.serve<Int32, Int32>("/first", [](const Int32&, Int32&) { return true; });
  }

  /// Lets each allocation of `add` fail in turn, and looks at what is left of it; then has `add` succeed.
  /// @return What `add` does, which then exists, and how many times it failed.
  template <class Endpoint>
  std::pair<Endpoint, int> withFailures(const std::function<Endpoint()>& add, const std::function<void()>& look) {
    for (int failures = 0;; ++failures) {
      std::optional<Endpoint> added;
      test::allocationsUntilFailure = failures + 1;
      try {
        added = add();
      } catch (const std::bad_alloc&) {
        added.reset();
      }
      const bool hasFailed = test::allocationsUntilFailure == 0;
      test::allocationsUntilFailure = 0;
      if (added && !hasFailed) return {std::move(*added), failures};
      // one that does without what failed is fine, too
      if (!added) look();
    }
  }

  /// No function, and nothing in the lists.
  void expectNothing() {
    EXPECT_EQ(owner_.use_count(), 1);
    EXPECT_TRUE(node_.ownTopics().empty());
    EXPECT_TRUE(node_.ownServices().empty());
  }

  /// What a failed subscription leaves where its topic has a publisher.
  void expectUnheard(Publisher& publisher) {
    EXPECT_EQ(owner_.use_count(), 1);
    const auto topics = node_.ownTopics();
    ASSERT_EQ(topics.size(), 1U);
    EXPECT_EQ(topics[0].publishers, 1);
    EXPECT_EQ(topics[0].subscriptions, 0);
    EXPECT_FALSE(publisher.hasSubscribers());
    transport_.dispatch();
    EXPECT_EQ(heard_, 0);
  }

  /// Without a publisher of the topic, and with one that has latched a message.
  void expectAllOrNothing(const std::function<Subscription()>& subscribe) {
    {
      const auto [subscription, failures] = withFailures(subscribe, [this] { expectNothing(); });
      EXPECT_GE(failures, 3);
    }
    expectNothing();
    Publisher publisher = node_.advertise<Int32>("/count", {.latched = true});
    publisher.publish(number(1));
    const auto [subscription, failures] = withFailures(subscribe, [&] { expectUnheard(publisher); });
    EXPECT_GE(failures, 3);
    EXPECT_EQ(publisher.newSubscribers(), 1U);
    transport_.dispatch();
    EXPECT_EQ(heard_, 1);
    publisher.publish(number(2));
    transport_.dispatch();
    EXPECT_EQ(heard_, 2);
  }

  /// @return A function for an endpoint, which owns something.
  template <class... Arguments>
  auto hearing() {
    return [this, owner = owner_](const Arguments&...) { ++heard_; };
  }

  Transport transport_{{.network = false, .domain = {}}};
  Node node_ = transport_.node();
  int heard_ = 0;
  /// Each function that is to be called has one, too.
  std::shared_ptr<int> owner_ = std::make_shared<int>();
};

TEST_F(NodeMemoryTest, AdvertisesOrLeavesNothing) {
  const auto advertise = [this] { return node_.advertise<Int32>("/count"); };
  const auto [publisher, failures] = withFailures<Publisher>(advertise, [this] { expectNothing(); });
  EXPECT_GE(failures, 3);
  EXPECT_EQ(node_.ownTopics().size(), 1U);
}

TEST_F(NodeMemoryTest, AdvertisesOrLeavesNothingWhereAnyTypeIsHeard) {
  const Subscription any = node_.subscribeAnyType("/count", hearing<std::string_view, std::span<const std::byte>>());
  const auto advertise = [this] { return node_.advertise<Int32>("/count"); };
  auto [publisher, failures] = withFailures<Publisher>(advertise, [this] {
    for (const OwnTopic& topic : node_.ownTopics()) EXPECT_EQ(topic.publishers, 0);
  });
  EXPECT_GE(failures, 3);
  publisher.publish(number(1));
  transport_.dispatch();
  EXPECT_EQ(heard_, 1);
}

TEST_F(NodeMemoryTest, SubscribesOrLeavesNothing) {
  expectAllOrNothing([this] { return node_.subscribe<Int32>("/count", hearing<Int32>()); });
}

TEST_F(NodeMemoryTest, SubscribesToBytesOrLeavesNothing) {
  expectAllOrNothing(
      [this] { return node_.subscribeBytes("/count", "ignition.msgs.Int32", hearing<std::span<const std::byte>>()); });
}

TEST_F(NodeMemoryTest, SubscribesAtOnceOrLeavesNothing) {
  expectAllOrNothing(
      [this] { return node_.subscribeAtOnce("/count", "ignition.msgs.Int32", hearing<Message, const Bulk*>()); });
}

TEST_F(NodeMemoryTest, SubscribesToBytesAtOnceOrLeavesNothing) {
  using Write = std::function<void(std::span<std::byte>)>;
  expectAllOrNothing(
      [this] { return node_.subscribeBytesAtOnce("/count", "ignition.msgs.Int32", hearing<std::size_t, Write>()); });
}

TEST_F(NodeMemoryTest, SubscribesToAnyTypeOrLeavesNothing) {
  expectAllOrNothing(
      [this] { return node_.subscribeAnyType("/count", hearing<std::string_view, std::span<const std::byte>>()); });
}

TEST_F(NodeMemoryTest, ServesOrLeavesNothing) {
  const std::function<Service()> serve = [this] {
    return node_.serve<Int32, Int32>("/double", [owner = owner_](const Int32&, Int32&) { return true; });
  };
  const auto ask = [this] {
    Int32 reply;
    EXPECT_EQ(node_.call("/double", number(1), reply, std::chrono::milliseconds(0)).outcome, CallOutcome::kNoService);
    expectNothing();
  };
  const auto [service, failures] = withFailures(serve, ask);
  EXPECT_GE(failures, 3);
  EXPECT_EQ(node_.ownServices().size(), 1U);
}

TEST_F(NodeMemoryTest, RequestsOrForgetsWhatToDoWithTheAnswer) {
  const Service service = node_.serve<Int32, Int32>("/double", [](const Int32&, Int32&) { return true; });
  const std::function<PendingRequest()> request = [this] {
    return node_.request("/double", number(1), "ignition.msgs.Int32", hearing<CallResult, Message>());
  };
  // several, for not each one that waits takes memory
  std::vector<PendingRequest> waiting;
  constexpr int kRequests = 8;
  for (int i = 0; i < kRequests; ++i) {
    const long owners = owner_.use_count();
    auto [pending, failures] = withFailures(request, [&] { EXPECT_EQ(owner_.use_count(), owners); });
    EXPECT_GE(failures, 3);
    waiting.push_back(std::move(pending));
  }
  transport_.dispatch();
  EXPECT_EQ(heard_, kRequests);
}

}  // namespace
}  // namespace pongsim
