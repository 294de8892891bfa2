#include "sim/running/runner.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/world_stats.pb.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/process.hh"
#include "support/wait_until.hh"

namespace pongsim::sim {
namespace {

constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w">
  <physics name="p" type="ignored"><max_step_size>0.001</max_step_size><real_time_factor>1</real_time_factor></physics>
  <model name="ball"><pose>0 0 100 0 0 0</pose><link name="l"><inertial><mass>1</mass></inertial></link></model>
  </world></sdf>)";

class RunnerTest : public testing::Test {
 protected:
  RunnerTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kWorld, "world.sdf", {.loadSystems = false}, diagnostics);
  }
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(RunnerTest, EndsAfterTheStepsAskedFor) {
  Runner runner(*simulation_, {.iterations = 250, .updateRate = 0.0});
  runner.run();
  EXPECT_EQ(simulation_->iterations(), 250U);
  EXPECT_EQ(simulation_->time(), std::chrono::milliseconds(250));
}

TEST_F(RunnerTest, MakesNoStepWhenAskedForNone) {
  Runner runner(*simulation_, {.iterations = 0});
  runner.run();
  EXPECT_EQ(simulation_->iterations(), 0U);
}

TEST_F(RunnerTest, CallsAfterEachStepAndEndsWhereThatSaysSo) {
  std::vector<std::uint64_t> steps;
  Runner runner(*simulation_, {.iterations = 250, .updateRate = 0.0, .stepped = [&](Simulation& simulation) {
                                 steps.push_back(simulation.iterations());
                                 return simulation.iterations() < 3;
                               }});
  runner.run();
  EXPECT_EQ(steps, (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(RunnerTest, IsNeverAheadOfTheWallClock) {
  const auto start = std::chrono::steady_clock::now();
  Runner runner(*simulation_, {.iterations = 200});
  runner.run();
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(199));
}

TEST_F(RunnerTest, TakesAnUpdateRateInPlaceOfTheFactor) {
  const auto start = std::chrono::steady_clock::now();
  Runner runner(*simulation_, {.iterations = 20, .updateRate = 100.0});
  runner.run();
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(190));
}

TEST_F(RunnerTest, StopsWhenTold) {
  for (const bool paused : {false, true}) {
    Runner runner(*simulation_, {.paused = paused});
    std::thread thread([&] { runner.run(); });
    runner.stop();
    thread.join();
  }
  SUCCEED();
}

TEST_F(RunnerTest, StaysWhereItIsWhilePaused) {
  Runner runner(*simulation_, {.paused = true, .iterations = 5});
  int heard = 0;
  Node node = simulation_->transport().node();
  // a second message shows that the loop continues after the first
  const Subscription clock = node.subscribe("/clock", "ignition.msgs.Clock", [&](const Message&) {
    if (++heard == 2) runner.stop();
  });
  runner.run();
  EXPECT_EQ(heard, 2);
  EXPECT_EQ(simulation_->iterations(), 0U);
}

/// A run on its own thread; the test's thread sends requests to it.
class ControlledRun : public RunnerTest {
 protected:
  ~ControlledRun() override { end(); }

  void start(const RunOptions& options) {
    runner_ = std::make_unique<Runner>(*simulation_, options);
    thread_ = std::thread([this] { runner_->run(); });
  }
  void end() {
    if (!thread_.joinable()) return;
    runner_->stop();
    thread_.join();
  }
  void waitForTheEnd() { thread_.join(); }

  /// @return Whether the response is `data: true`.
  bool ask(const std::string& service, const std::string& type, const std::string& text) {
    const MessagePointer request = newMessage(type);
    EXPECT_FALSE(parseMessage(text, *request));
    ignition::msgs::Boolean reply;
    const CallResult result = simulation_->transport().node().call(service, *request, reply, test::kDeadline);
    EXPECT_TRUE(result) << result.error;
    return reply.data();
  }
  /// @return Why the service refused the request; empty if it did not.
  std::string refusal(const std::string& service, const std::string& type, const std::string& text) {
    const MessagePointer request = newMessage(type);
    EXPECT_FALSE(parseMessage(text, *request));
    ignition::msgs::Boolean reply;
    const CallResult result = simulation_->transport().node().call(service, *request, reply, test::kDeadline);
    if (result) return "";
    EXPECT_EQ(result.outcome, CallOutcome::kRefused) << result.error;
    const std::string_view before = " refused: ";
    return result.error.substr(result.error.find(before) + before.size());
  }
  bool control(const std::string& text) { return ask("/world/w/control", "WorldControl", text); }

  std::unique_ptr<Runner> runner_;
  std::thread thread_;
};

TEST_F(ControlledRun, PlaysAndEndsAfterTheStepsAskedFor) {
  start({.paused = true, .iterations = 30});
  EXPECT_TRUE(control("pause: true, multi_step: 10"));
  EXPECT_TRUE(control("pause: false"));
  waitForTheEnd();
  EXPECT_EQ(simulation_->iterations(), 30U);
}

TEST_F(ControlledRun, MakesNoStepAfterAnAnsweredPause) {
  start({.updateRate = 0.0});
  EXPECT_TRUE(control("pause: true"));
  const Time paused = simulation_->time();
  EXPECT_EQ(refusal("/world/w/control", "WorldControl", "reset {time_only: true}"),
            "only the whole world can be reset: reset {all: true}");
  EXPECT_NE(refusal("/world/w/control", "WorldControl", "seed: 5"), "");
  EXPECT_EQ(simulation_->time(), paused);
}

TEST_F(ControlledRun, RunsToTheTimeAskedFor) {
  start({.paused = true, .updateRate = 0.0});
  std::atomic<bool> pausedAgain = false;
  Node node = simulation_->transport().node();
  const Subscription statistics =
      node.subscribe<ignition::msgs::WorldStatistics>("/stats", [&](const ignition::msgs::WorldStatistics& message) {
        if (message.paused() && message.iterations() > 0) pausedAgain = true;
      });
  EXPECT_TRUE(control("run_to_sim_time {nsec: 500000000}"));
  while (!pausedAgain) std::this_thread::yield();
  end();
  EXPECT_EQ(simulation_->time(), std::chrono::milliseconds(500));
}

TEST_F(ControlledRun, GoesBackToTheStartWhenReset) {
  const std::uint64_t atStart = simulation_->stateHash();
  simulation_->step(100);
  EXPECT_NE(simulation_->stateHash(), atStart);
  start({.paused = true});
  EXPECT_TRUE(control("pause: true, reset {all: true}"));
  end();
  EXPECT_EQ(simulation_->time(), Time::zero());
  EXPECT_EQ(simulation_->stateHash(), atStart);
}

TEST_F(RunnerTest, PausesBehindTheStepsThatAreLeftWhenResetAmongThem) {
  // all on this thread: a request is handled before the step that follows it
  Runner runner(*simulation_, {.paused = true, .updateRate = 0.0});
  Node node = simulation_->transport().node();
  const auto control = [&node](const std::string& text) {
    const MessagePointer request = newMessage("WorldControl");
    EXPECT_FALSE(parseMessage(text, *request));
    EXPECT_TRUE(node.request("/world/w/control", *request, "ignition.msgs.Boolean", {}));
  };
  std::vector<std::uint64_t> counts;
  const Subscription steps =
      node.subscribe<ignition::msgs::WorldStatistics>("/stats", [&](const ignition::msgs::WorldStatistics& told) {
        counts.push_back(told.iterations());
        if (counts.size() == 1) control("pause: true, multi_step: 10");
        if (told.iterations() == 4 && std::ranges::count(counts, 4U) == 1) control("reset {all: true}");
        if (told.paused() && counts.size() > 8) runner.stop();
      });
  runner.run();
  EXPECT_EQ(std::ranges::max(counts), 5U);
  EXPECT_EQ(simulation_->iterations(), 5U);
}

TEST_F(ControlledRun, DoesWhatOtherThreadsPostBetweenSteps) {
  for (const bool paused : {false, true}) {
    start({.paused = paused, .updateRate = 0.0});
    std::atomic<Simulation*> seen = nullptr;
    runner_->post([&](Simulation& simulation) { seen = &simulation; });
    EXPECT_TRUE(test::waitUntil([&] { return seen == simulation_.get(); }));
    end();
    runner_.reset();
  }
}

TEST_F(RunnerTest, TellsOfTheFirstWorldOnTopicsOfTheProcess) {
  const auto hasClock = [this] {
    return std::ranges::count(simulation_->transport().node().ownTopics(), "/clock", &OwnTopic::name) > 0;
  };
  const auto isServed = [this](const std::string& service) {
    return static_cast<bool>(
        simulation_->transport().node().request(service, *newMessage("Empty"), "ignition.msgs.StringMsg_V", {}));
  };
  {
    const Runner other(*simulation_, {}, {});
    EXPECT_FALSE(hasClock());
    EXPECT_FALSE(isServed("/gazebo/resource_paths/get"));
  }
  Runner first(*simulation_, {});
  EXPECT_TRUE(hasClock());
  EXPECT_TRUE(isServed("/gazebo/resource_paths/get"));
  first.leave();
  EXPECT_FALSE(hasClock());
  EXPECT_FALSE(isServed("/gazebo/resource_paths/get"));
}

}  // namespace
}  // namespace pongsim::sim
