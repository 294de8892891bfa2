// What a node does where memory for an endpoint fails: it has the endpoint, or nothing of it is left.
#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <optional>

#include "pongsim/node.hh"

namespace {

// Of this thread's allocations; counts down to the one that fails.
thread_local long untilFailure = 0;

void* failing(std::size_t size) {
  if (untilFailure > 0 && --untilFailure == 0) throw std::bad_alloc();
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return failing(size); }
void* operator new[](std::size_t size) { return failing(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

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
      untilFailure = failures + 1;
      try {
        added = add();
      } catch (const std::bad_alloc&) {
        added.reset();
      }
      const bool hasFailed = untilFailure == 0;
      untilFailure = 0;
      if (added && !hasFailed) return {std::move(*added), failures};
      // one that does without what failed is fine, too
      if (!added) look();
    }
  }

  void expectNothing() {
    EXPECT_TRUE(node_.ownTopics().empty());
    EXPECT_TRUE(node_.ownServices().empty());
    transport_.dispatch();
    EXPECT_EQ(heard_, 0);
  }

  /// What subscriptions leave where there is a publisher of their topic, which others than they then still hear.
  void expectUnheard(Publisher& publisher) {
    const auto topics = node_.ownTopics();
    ASSERT_EQ(topics.size(), 1U);
    EXPECT_EQ(topics[0].publishers, 1);
    EXPECT_EQ(topics[0].subscriptions, 0);
    EXPECT_FALSE(publisher.hasSubscribers());
    publisher.publish(number(1));
    transport_.dispatch();
    EXPECT_EQ(heard_, 0);
  }

  template <class Subscribe>
  void expectAllOrNothing(const Subscribe& subscribe) {
    const std::function<Subscription()> add = subscribe;
    {
      const auto [subscription, failures] = withFailures(add, [this] { expectNothing(); });
      EXPECT_GE(failures, 3);
    }
    Publisher publisher = node_.advertise<Int32>("/count", {.latched = true});
    publisher.publish(number(1));
    const auto [subscription, failures] = withFailures(add, [&] { expectUnheard(publisher); });
    transport_.dispatch();
    heard_ = 0;
    publisher.publish(number(2));
    transport_.dispatch();
    EXPECT_EQ(heard_, 1);
  }

  Transport transport_{{.network = false, .domain = {}}};
  Node node_ = transport_.node();
  int heard_ = 0;
};

TEST_F(NodeMemoryTest, AdvertisesOrLeavesNothing) {
  const auto advertise = [this] { return node_.advertise<Int32>("/count"); };
  const auto [publisher, failures] = withFailures<Publisher>(advertise, [this] { expectNothing(); });
  EXPECT_GE(failures, 3);
  EXPECT_EQ(node_.ownTopics().size(), 1U);
}

TEST_F(NodeMemoryTest, AdvertisesOrLeavesNothingWhereAnyTypeIsHeard) {
  const Subscription any = node_.subscribeAnyType("/count", [this](auto, auto) { ++heard_; });
  const auto advertise = [this] { return node_.advertise<Int32>("/count"); };
  auto [publisher, failures] = withFailures<Publisher>(advertise, [this] {
    for (const OwnTopic& topic : node_.ownTopics()) EXPECT_EQ(topic.publishers, 0);
  });
  publisher.publish(number(1));
  transport_.dispatch();
  // not more, and not at all if its memory failed when the publisher came
  EXPECT_LE(heard_, 1);
}

TEST_F(NodeMemoryTest, SubscribesOrLeavesNothing) {
  expectAllOrNothing([this] { return node_.subscribe<Int32>("/count", [this](const Int32&) { ++heard_; }); });
}

TEST_F(NodeMemoryTest, SubscribesToBytesOrLeavesNothing) {
  expectAllOrNothing(
      [this] { return node_.subscribeBytes("/count", "ignition.msgs.Int32", [this](auto) { ++heard_; }); });
}

TEST_F(NodeMemoryTest, SubscribesAtOnceOrLeavesNothing) {
  expectAllOrNothing([this] {
    return node_.subscribeAtOnce("/count", "ignition.msgs.Int32", [this](const Message&, const Bulk*) { ++heard_; });
  });
}

TEST_F(NodeMemoryTest, SubscribesToAnyTypeOrLeavesNothing) {
  const std::function<Subscription()> subscribe = [this] {
    return node_.subscribeAnyType("/count", [this](auto, auto) { ++heard_; });
  };
  const auto [subscription, failures] = withFailures(subscribe, [this] { expectNothing(); });
  EXPECT_GE(failures, 3);
}

TEST_F(NodeMemoryTest, ServesOrLeavesNothing) {
  const std::function<Service()> serve = [this] {
    return node_.serve<Int32, Int32>("/double", [this](const Int32&, Int32&) {
      ++heard_;
      return true;
    });
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

}  // namespace
}  // namespace pongsim
