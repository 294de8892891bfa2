#include "transport/input_gate.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/int32.pb.h>

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "pongsim/node.hh"

namespace pongsim::transport {
namespace {

using ignition::msgs::Boolean;
using ignition::msgs::Int32;

/// Stands for a system of a world, which acts where the test says so.
class Part final : public CallGuard {
 public:
  using CallGuard::call;
  void call(Moment, void (*function)(void* data), void* data) override {
    const bool before = std::exchange(isRunning, true);
    function(data);
    isRunning = before;
  }
  void advertised(std::string_view, std::string_view) override {}
  bool isOfWorld() const override { return true; }
  bool isActing() const override { return isRunning && std::this_thread::get_id() == thread; }

  bool isRunning = false;
  const std::thread::id thread = std::this_thread::get_id();
};

/// A world whose part hears two topics, answers a service, and publishes on both topics.
class World {
 public:
  explicit World(std::size_t queueLength = 1000) {
    const SubscriptionOptions options{.queueLength = queueLength};
    for (const char* name : {"a", "b", "a"}) {
      subscriptions_.push_back(node.subscribe<Int32>(
          std::string("/") + name,
          [this, who = std::string(name) + std::to_string(subscriptions_.size())](const Int32& message) {
            heard.push_back(who + ":" + std::to_string(message.data()));
          },
          options));
    }
    a = node.advertise<Int32>("/a");
    service_ = node.serve<Int32, Boolean>("/ask", [this](const Int32& request, Boolean&) {
      heard.push_back("asked:" + std::to_string(request.data()));
      return true;
    });
  }

  /// Publishes as the part does in its own step.
  void publishOwn(int number) {
    part.isRunning = true;
    a.publish(message(number));
    part.isRunning = false;
  }
  void requestOwn(int number) {
    part.isRunning = true;
    requests_.push_back(node.request("/ask", message(number), Boolean::descriptor()->full_name(), [](auto&&...) {}));
    part.isRunning = false;
  }
  static Int32 message(int number) {
    Int32 message;
    message.set_data(number);
    return message;
  }

  Part part;
  Transport transport{{.network = false, .domain = {}}};
  Node outside = transport.node();
  Node node = outside.guardedBy(part);
  Publisher a;
  std::vector<std::string> heard;

 private:
  std::vector<Subscription> subscriptions_;
  std::vector<PendingRequest> requests_;
  Service service_;
};

using Words = std::vector<std::string>;

/// Runs what `first` does to a world from inside and outside, records it, and plays it to a world to which only
/// `inside` is done.
/// @return What the second has heard.
template <class Both, class Inside>
void expectSame(const Both& both, const Inside& inside, const Words& expected, std::size_t queueLength = 1000) {
  Intake taken;
  {
    World world(queueLength);
    InputGate gate(world.transport, InputGate::Use::kNote);
    both(world);
    world.transport.dispatch();
    EXPECT_EQ(world.heard, expected);
    taken = gate.intake;
  }
  World world(queueLength);
  InputGate gate(world.transport, InputGate::Use::kReplace);
  inside(world);
  gate.handOver(taken);
  world.transport.dispatch();
  EXPECT_EQ(world.heard, expected);
  EXPECT_TRUE(gate.missing.empty());
  world.heard.clear();
  world.transport.dispatch();
  EXPECT_EQ(world.heard, Words());
}

TEST(InputGate, PlaysMessagesFromOutsideWhereTheyWere) {
  expectSame(
      [](World& world) {
        Publisher b = world.outside.advertise<Int32>("/b");
        Publisher a = world.outside.advertise<Int32>("/a");
        b.publish(World::message(1));
        world.publishOwn(2);
        a.publish(World::message(3));
        world.publishOwn(4);
      },
      [](World& world) {
        world.publishOwn(2);
        world.publishOwn(4);
      },
      {"b1:1", "a0:2", "a2:2", "a0:3", "a2:3", "a0:4", "a2:4"});
}

TEST(InputGate, PlaysWhatAFullSubscriptionKept) {
  expectSame(
      [](World& world) {
        Publisher a = world.outside.advertise<Int32>("/a");
        world.publishOwn(1);
        world.publishOwn(2);
        a.publish(World::message(3));
      },
      [](World& world) {
        world.publishOwn(1);
        world.publishOwn(2);
      },
      {"a0:2", "a2:2", "a0:3", "a2:3"}, 2);
}

TEST(InputGate, PlaysRequestsFromOutsideWhereTheyWere) {
  expectSame(
      [](World& world) {
        PendingRequest first = world.outside.request("/ask", World::message(1), "ignition.msgs.Boolean", {});
        world.requestOwn(2);
        PendingRequest second = world.outside.request("/ask", World::message(3), "ignition.msgs.Boolean", {});
      },
      [](World& world) { world.requestOwn(2); }, {"asked:1", "asked:2", "asked:3"});
}

TEST(InputGate, PlaysRequestsWithoutMessages) {
  World world;
  InputGate gate(world.transport, InputGate::Use::kReplace);
  world.publishOwn(1);
  gate.handOver({{}, {}, {{0, "/ask", {}}}});
  gate.serve();
  EXPECT_EQ(world.heard, (Words{"asked:0"}));
  world.transport.dispatch();
  EXPECT_EQ(world.heard, (Words{"asked:0", "a0:1", "a2:1"}));
}

TEST(InputGate, TakesWhatAnotherThreadOfAPartPublishesForInput) {
  World world;
  InputGate gate(world.transport, InputGate::Use::kNote);
  world.part.isRunning = true;
  std::thread([&] { world.a.publish(World::message(1)); }).join();
  world.part.isRunning = false;
  world.transport.dispatch();
  EXPECT_EQ(gate.intake.messages.size(), 2U);
}

TEST(InputGate, NotesNothingOfTheWorldItself) {
  World world;
  InputGate gate(world.transport, InputGate::Use::kNote);
  world.publishOwn(1);
  world.requestOwn(2);
  world.transport.dispatch();
  EXPECT_EQ(world.heard.size(), 3U);
  EXPECT_TRUE(gate.intake.isEmpty());
}

TEST(InputGate, KeepsOutWhatComesWhileItReplaces) {
  World world;
  InputGate gate(world.transport, InputGate::Use::kReplace);
  Publisher a = world.outside.advertise<Int32>("/a");
  a.publish(World::message(1));
  std::optional<CallResult> answered;
  const PendingRequest pending =
      world.outside.request("/ask", World::message(2), "ignition.msgs.Boolean",
                            [&](const CallResult& result, const Message&) { answered = result; });
  world.transport.dispatch();
  EXPECT_EQ(world.heard, Words());
  ASSERT_TRUE(answered);
  EXPECT_EQ(answered->outcome, CallOutcome::kGone);
}

TEST(InputGate, SaysWhatTheWorldLacks) {
  World world;
  InputGate gate(world.transport, InputGate::Use::kReplace);
  gate.handOver({{{0, {"/c", "ignition.msgs.Int32", 0}, {}}, {1, {"/a", "ignition.msgs.Int32", 7}, {}}},
                 {},
                 {{0, "/other", {}}}});
  world.transport.dispatch();
  EXPECT_EQ(gate.missing, (Words{"a subscription to '/c' of type ignition.msgs.Int32",
                                 "a subscription to '/a' of type ignition.msgs.Int32", "the service '/other'"}));
}

TEST(InputGate, MeetsTypesForSubscriptionsToAny) {
  World world;
  const Subscription any = world.node.subscribeAnyType("/any", [&](std::string_view type, auto bytes) {
    world.heard.push_back(std::string(type) + ":" + std::to_string(bytes.size()));
  });
  InputGate gate(world.transport, InputGate::Use::kReplace);
  gate.handOver({{{0, {"/any", "ignition.msgs.Int32", 0}, {}}}, {}, {}});
  world.transport.dispatch();
  EXPECT_EQ(world.heard, (Words{"ignition.msgs.Int32:0"}));
}

}  // namespace
}  // namespace pongsim::transport
