#include "sim/running/lockstep.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/int32.pb.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "pongsim/system.hh"
#include "sim/running/runner.hh"
#include "support/process.hh"
#include "support/wait_until.hh"

namespace pongsim::sim {
namespace {

using ignition::msgs::Int32;
using Words = std::vector<std::string>;

/// Publishes the number of each step on /told, and notes what comes on /push and /other, with the step before.
class Listener final : public System {
 public:
  explicit Listener(Words& heard) : heard_(heard) {}
  void configure(const SystemContext& context) override {
    told_ = context.node.advertise<Int32>("/told");
    push_ = context.node.subscribe<Int32>("/push", [this](const Int32& message) { note("push", message); });
    other_ = context.node.subscribe<Int32>("/other", [this](const Int32& message) { note("other", message); });
  }
  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    step_ = info.iteration;
    Int32 message;
    message.set_data(static_cast<std::int32_t>(info.iteration));
    told_.publish(message);
  }
  void reset() override { step_ = 0; }

 private:
  void note(const std::string& topic, const Int32& message) {
    heard_.push_back(topic + " " + std::to_string(message.data()) + " after " + std::to_string(step_));
  }
  Words& heard_;
  std::uint64_t step_ = 0;
  Publisher told_;
  Subscription push_, other_;
};

/// A controller on its own thread, with a transport of its own, which answers to /told.
class Controller {
 public:
  using Answer = std::function<void(Controller&, int step)>;

  Controller(Transport& transport, Answer answer)
      : transport_(transport, Transport::Sharing()),
        push_(transport_.node().advertise<Int32>("/push")),
        other_(transport_.node().advertise<Int32>("/other")),
        told_(transport_.node().subscribe<Int32>(
            "/told", [this, answer = std::move(answer)](const Int32& message) { answer(*this, message.data()); })),
        thread_([this] {
          while (!isOver_) transport_.dispatchFor(std::chrono::milliseconds(10));
        }) {}
  ~Controller() {
    isOver_ = true;
    transport_.wake();
    thread_.join();
  }
  void push(int value) { publish(push_, value); }
  void other(int value) { publish(other_, value); }

 private:
  static void publish(Publisher& publisher, int value) {
    Int32 message;
    message.set_data(value);
    publisher.publish(message);
  }

  Transport transport_;
  Publisher push_, other_;
  Subscription told_;
  std::atomic<bool> isOver_ = false;
  std::thread thread_;
};

class LockstepTest : public testing::Test {
 protected:
  LockstepTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "world.sdf",
                                       {.loadSystems = false}, diagnostics);
    simulation_->addSystem("listener", std::make_unique<Listener>(heard_), diagnostics);
  }

  static RunOptions options(std::uint64_t steps, std::vector<LockstepOptions::Topic> topics) {
    return {.iterations = steps,
            .updateRate = 0.0,
            .lockstep = LockstepOptions{.topics = std::move(topics), .heard = {"/told"}}};
  }

  Words heard_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(LockstepTest, WaitsForAnAnswerToEachStep) {
  std::minstd_rand random;
  const Controller controller(simulation_->transport(), [&](Controller& self, int step) {
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
    self.other(10 * step);
    self.push(step);
  });
  Runner runner(*simulation_, options(50, {{"/push"}}));
  runner.run();
  EXPECT_TRUE(runner.outcome()) << runner.outcome().error;
  Words expected;
  for (int step = 1; step < 50; ++step) {
    const std::string after = " after " + std::to_string(step);
    expected.push_back("other " + std::to_string(10 * step) + after);
    expected.push_back("push " + std::to_string(step) + after);
  }
  EXPECT_EQ(heard_, expected);
}

TEST_F(LockstepTest, TakesAsManyMessagesAsAskedForAfterAsManySteps) {
  const Controller controller(simulation_->transport(), [](Controller& self, int step) {
    if (step % 2 == 0) self.push(step);
  });
  Runner runner(*simulation_, options(9, {{"/push", 4, 2}}));
  runner.run();
  EXPECT_EQ(heard_, (Words{"push 2 after 4", "push 4 after 4", "push 6 after 8", "push 8 after 8"}));
}

TEST_F(LockstepTest, CountsMessagesThatCameEarlyInTheirOrder) {
  const Controller controller(simulation_->transport(), [](Controller& self, int step) { self.push(step); });
  Runner runner(*simulation_, options(4, {{"/push"}}));
  // before the world runs
  runner.post([](Simulation& simulation) {
    Publisher carrier = simulation.transport().node().advertise("/push", "ignition.msgs.Int32", {.relays = true});
    Int32 hello;
    hello.set_data(-1);
    carrier.publish(hello);
  });
  runner.run();
  EXPECT_EQ(heard_, (Words{"push -1 after 1", "push 1 after 2", "push 2 after 3"}));
}

TEST_F(LockstepTest, BeginsForASenderThatHearsNothing) {
  Transport outside(simulation_->transport(), Transport::Sharing());
  RunOptions run = options(5, {{"/push", 2}});
  run.lockstep->heard.clear();
  Runner runner(*simulation_, run);
  {
    Publisher push = outside.node().advertise<Int32>("/push");
    for (const int value : {1, 2}) {
      Int32 message;
      message.set_data(value);
      push.publish(message);
    }
  }
  runner.run();
  EXPECT_TRUE(runner.outcome()) << runner.outcome().error;
  EXPECT_EQ(heard_, (Words{"push 1 after 2", "push 2 after 4"}));
}

TEST_F(LockstepTest, EndsWhereNobodyIsThereInTime) {
  RunOptions run = options(5, {{"/push"}});
  run.lockstep->timeout = std::chrono::milliseconds(20);
  Runner runner(*simulation_, run);
  runner.run();
  EXPECT_EQ(simulation_->iterations(), 0U);
  EXPECT_EQ(runner.outcome().error,
            "lockstep: nobody publishes on '/push'; nobody subscribes to '/told' within 0.02 s");
}

TEST_F(LockstepTest, EndsWhereAMessageIsLate) {
  const Controller controller(simulation_->transport(), [](Controller& self, int step) {
    if (step < 3) self.push(step);
  });
  RunOptions run = options(5, {{"/push"}});
  run.lockstep->timeout = std::chrono::seconds(3);
  Runner runner(*simulation_, run);
  runner.run();
  EXPECT_EQ(simulation_->iterations(), 3U);
  EXPECT_EQ(runner.outcome().error, "lockstep: no message on '/push' for step 3 from this process within 3 s");
}

TEST_F(LockstepTest, GoesOnAsToldWithoutCountingWhatComesLate) {
  const Controller controller(simulation_->transport(), [](Controller& self, int step) {
    // the answer to the second step comes with the third's
    if (step == 2) return;
    if (step == 3) self.push(2);
    self.push(step);
  });
  RunOptions run = options(5, {{"/push"}});
  run.lockstep->timeout = std::chrono::seconds(1);
  run.lockstep->goesOnWhenLate = true;
  Runner runner(*simulation_, run);
  runner.run();
  EXPECT_TRUE(runner.outcome());
  EXPECT_EQ(simulation_->iterations(), 5U);
  ASSERT_FALSE(heard_.empty());
  EXPECT_EQ(heard_.front(), "push 1 after 1");
}

TEST_F(LockstepTest, EndsWhereMoreComesThanIsTaken) {
  const Controller controller(simulation_->transport(), [](Controller& self, int step) {
    for (int i = 0; i < 100; ++i) self.push(step);
  });
  Runner runner(*simulation_, options(5000, {{"/push"}}));
  runner.run();
  EXPECT_LT(simulation_->iterations(), 5000U);
  EXPECT_NE(runner.outcome().error.find("more come than the 1 that are taken in every 1 steps"), std::string::npos)
      << runner.outcome().error;
}

TEST_F(LockstepTest, AnswersRequestsWhileItWaits) {
  std::atomic<int> last = 0;
  const Controller controller(simulation_->transport(), [&](Controller& self, int step) {
    last = step;
    if (step != 3) self.push(step);
  });
  RunOptions run = options(100, {{"/push"}});
  Runner runner(*simulation_, run);
  std::thread thread([&] { runner.run(); });
  EXPECT_TRUE(test::waitUntil([&] { return last == 3; }));
  const auto control = [&](const std::string& text) {
    Transport client(simulation_->transport(), Transport::Sharing());
    const MessagePointer request = newMessage("WorldControl");
    EXPECT_FALSE(parseMessage(text, *request));
    ignition::msgs::Boolean reply;
    EXPECT_TRUE(client.node().call("/world/w/control", *request, reply, test::kDeadline));
  };
  control("pause: true");
  EXPECT_EQ(last, 3);
  last = 0;
  // as from the start, with the same answers: the wait is that of another step
  control("reset {all: true}");
  EXPECT_TRUE(test::waitUntil([&] { return last == 3; }));
  runner.stop();
  thread.join();
  EXPECT_TRUE(runner.outcome());
  EXPECT_EQ(heard_, (Words{"push 1 after 1", "push 2 after 2", "push 1 after 1", "push 2 after 2"}));
}

}  // namespace
}  // namespace pongsim::sim
