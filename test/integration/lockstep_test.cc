// Runs in lockstep with a controller, in another process and over DDS.
#include <gtest/gtest.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "integration/program.hh"
#include "pongsim/node.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::test {
namespace {

using ignition::msgs::Clock;
using ignition::msgs::Twist;

/// Answers to each tenth step with a Twist, on a thread of its own.
class Driver {
 public:
  /// @param delay Called before each answer with the number of the step; false: it answers no more.
  explicit Driver(std::function<bool(std::uint64_t step)> delay) : delay_(std::move(delay)) {
    testDomain();
    transport_.emplace();
    command_ = transport_->node().advertise<Twist>("/cmd_vel");
    thread_ = std::thread([this] {
      // only then it hears the clock: who hears it can answer
      while (!isOver_ && !command_.waitForSubscribers(std::chrono::milliseconds(10))) continue;
      clock_ = transport_->node().subscribe<Clock>("/clock", [this](const Clock& clock) { answer(clock); });
      while (!isOver_) transport_->dispatchFor(std::chrono::milliseconds(10));
    });
  }
  ~Driver() {
    isOver_ = true;
    thread_.join();
  }
  std::uint64_t answers() const { return answers_; }

 private:
  void answer(const Clock& clock) {
    const auto step = static_cast<std::uint64_t>(clock.sim().sec() * 1000 + clock.sim().nsec() / 1000000);
    if (step % 10 != 0 || isSilent_ || !delay_(step)) {
      isSilent_ = isSilent_ || step % 10 == 0;
      return;
    }
    Twist twist;
    twist.mutable_linear()->set_x(0.5 + 0.001 * static_cast<double>(step % 70));
    twist.mutable_angular()->set_z(step % 40 < 20 ? 1 : -0.7);
    command_.publish(twist);
    ++answers_;
  }

  const std::function<bool(std::uint64_t)> delay_;
  std::optional<Transport> transport_;
  Publisher command_;
  Subscription clock_;
  bool isSilent_ = false;
  std::atomic<std::uint64_t> answers_ = 0;
  std::atomic<bool> isOver_ = false;
  std::thread thread_;
};

/// Keeps the processors busy.
class Load {
 public:
  Load() {
    for (int i = 0; i < 4; ++i) {
      threads_.emplace_back([this] {
        while (!isOver_) {
        }
      });
    }
  }
  ~Load() {
    isOver_ = true;
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::atomic<bool> isOver_ = false;
  std::vector<std::thread> threads_;
};

std::vector<std::string> lockstepRun(std::vector<std::string> more) {
  std::vector<std::string> arguments = {"run",         ownWorld("pong_world.sdf"), "-z",    "0", "--hash", "--lockstep",
                                        "/cmd_vel:10", "--lockstep-start",         "/clock"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Lockstep, GivesTheSameBitsHoweverSlowTheControllerIs) {
  std::string first;
  for (unsigned run = 0; run < 4; ++run) {
    std::minstd_rand random(run + 1);
    const Driver driver([&](std::uint64_t) {
      if (run > 0) std::this_thread::sleep_for(std::chrono::microseconds(random() % 50000));
      return true;
    });
    std::optional<Load> load;
    if (run > 1) load.emplace();
    const Outcome outcome = runToEnd(lockstepRun({"--iterations", "500"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    if (run == 0) first = outcome.output;
    EXPECT_EQ(outcome.output, first) << "run " << run;
    // one for each tick; the clock of the last step, which nobody waits for, may be lost when the run ends
    EXPECT_GE(driver.answers(), 49U);
  }
  const Outcome alone = runToEnd({"run", ownWorld("pong_world.sdf"), "-z", "0", "--hash", "--iterations", "500"});
  EXPECT_NE(alone.output, first);
}

TEST(Lockstep, TakesTheMessagesOfASenderByTheirOrder) {
  const auto hashWith = [](const char* rate) {
    const auto world = start(
        {"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "3000", "--hash", "--lockstep", "/cmd_vel:500"});
    const Outcome sent = runToEnd({"topic", "-t", "/cmd_vel", "-m", "ignition.msgs.Twist", "-p", "linear: {x: 0.5}",
                                   "--rate", rate, "-n", "5", "--timeout", "60"});
    EXPECT_EQ(sent.exitCode, 0) << sent.error;
    EXPECT_EQ(world->wait(), 0) << world->error();
    return world->output();
  };
  EXPECT_EQ(hashWith("2"), hashWith("100"));
}

TEST(Lockstep, EndsWhereTheControllerDies) {
  const Driver driver([](std::uint64_t step) { return step < 100; });
  const Outcome outcome = runToEnd(lockstepRun({"--lockstep-timeout", "2"}));
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find("error: lockstep: no message on '/cmd_vel' for step 100 from process " +
                               std::to_string(getpid()) + " within 2 s"),
            std::string::npos)
      << outcome.error;
  EXPECT_NE(outcome.output.find("state hash: "), std::string::npos);
}

TEST(Lockstep, CanBePausedAndStoppedWhileItWaits) {
  const Driver driver([](std::uint64_t step) { return step < 100; });
  const auto world = start(lockstepRun({}));
  ASSERT_TRUE(waitUntil([&] { return driver.answers() == 9; }));
  const Outcome paused =
      runToEnd({"service", "-s", "/world/pong_world/control", "--reqtype", "ignition.msgs.WorldControl", "--reptype",
                "ignition.msgs.Boolean", "--timeout", "60000", "--req", "pause: true"});
  EXPECT_EQ(paused.exitCode, 0) << paused.error;
  world->kill(SIGINT);
  EXPECT_EQ(world->wait(), 0) << world->error();
}

TEST(Lockstep, WaitsForTheControllerBeforeTheFirstStep) {
  const auto world = start(lockstepRun({"--iterations", "30"}));
  ASSERT_TRUE(world->waitForError("world '")) << world->error();
  const Driver driver([](std::uint64_t) { return true; });
  EXPECT_EQ(world->wait(), 0) << world->error();
  EXPECT_TRUE(waitUntil([&] { return driver.answers() == 3; }));
}

/// With messages on several topics, services that are called while the world waits, a pause and a reset.
TEST(Lockstep, RecordsItsInputsForAReplay) {
  const TempFolder folder;
  const std::string recording = (folder.path() / "run.inputs").string();
  const auto ask = [](const std::string& service, const std::string& type, const std::string& request) {
    const Outcome asked =
        runToEnd({"service", "-s", "/world/pong_world/" + service, "--reqtype", "ignition.msgs." + type, "--reptype",
                  "ignition.msgs.Boolean", "--timeout", "60000", "--req", request});
    EXPECT_EQ(asked.exitCode, 0) << asked.error;
  };
  int resets = 0;
  const Driver driver([&](std::uint64_t step) {
    if (step == 100) ask("set_pose", "Pose", "name: 'pong_bot', position {y: 0.5, z: 0.3}");
    if (step == 150)
      ask("create", "EntityFactory", "clone_name: 'pong_bot', name: 'twin', pose {position {y: 3, z: 1}}");
    if (step == 200 && resets++ == 0) ask("control", "WorldControl", "reset {all: true}");
    if (step == 250) ask("remove", "Entity", "name: 'twin', type: MODEL");
    if (step == 250) ask("control", "WorldControl", "pause: true");
    if (step == 250) ask("control", "WorldControl", "pause: false");
    return true;
  });
  const Outcome run = runToEnd(lockstepRun({"--iterations", "500", "--record-inputs", recording}));
  ASSERT_EQ(run.exitCode, 0) << run.error;
  EXPECT_EQ(resets, 2);
  const std::string hash = run.output.substr(run.output.find(": ") + 2, 16);
  for (const char* threads : {"1", "2"}) {
    const Outcome replay = runToEnd({"replay", recording, "--threads", threads});
    EXPECT_EQ(replay.exitCode, 0) << replay.error << replay.output;
    EXPECT_NE(replay.output.find("is as recorded up to step 500"), std::string::npos) << replay.output;
    EXPECT_NE(replay.output.find("state hash " + hash), std::string::npos) << replay.output;
  }
}

TEST(Lockstep, SaysWhatIsWrongWithItsOptions) {
  const Outcome wrong = runToEnd({"run", ownWorld("pong_world.sdf"), "--lockstep", "/cmd vel"});
  EXPECT_EQ(wrong.exitCode, 2) << wrong.error;
  const Outcome several = runToEnd({"run", ownWorld("three_worlds.sdf"), "--lockstep", "/cmd_vel"});
  EXPECT_EQ(several.exitCode, 1);
  EXPECT_NE(several.error.find("a run in lockstep is of a single world\n  hint: choose one"), std::string::npos)
      << several.error;
  const Outcome unknown = runToEnd(
      {"run", ownWorld("pong_world.sdf"), "--lockstep", "/cmd_vle", "--iterations", "1", "--lockstep-timeout", "0.1"});
  EXPECT_NE(unknown.error.find("no system of the world subscribes to '/cmd_vle': did you mean '/cmd_vel'?"),
            std::string::npos)
      << unknown.error;
}

}  // namespace
}  // namespace pongsim::test
