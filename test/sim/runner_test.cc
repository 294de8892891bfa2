#include "sim/runner.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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
  // Two messages prove that the loop goes round.
  const Subscription clock = node.subscribe("/clock", "ignition.msgs.Clock", [&](const Message&) {
    if (++heard == 2) runner.stop();
  });
  runner.run();
  EXPECT_EQ(heard, 2);
  EXPECT_EQ(simulation_->iterations(), 0U);
}

}  // namespace
}  // namespace pongsim::sim
