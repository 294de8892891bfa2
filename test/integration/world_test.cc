#include <gtest/gtest.h>
#include <signal.h>

#include <string>

#include "integration/program.hh"
#include "support/regex.hh"

namespace pongsim::test {
namespace {

/// @return The status of the run: "simulated 0.100 s, ..., 100 iterations, paused".
std::string state() {
  const Outcome stats = runToEnd({"world", "stats", "-n", "1", "--timeout", "60000"});
  EXPECT_EQ(stats.exitCode, 0) << stats.error;
  return stats.output;
}

int ask(std::vector<std::string> action) {
  action.insert(action.begin(), "world");
  action.insert(action.end(), {"--timeout", "60000"});
  const Outcome outcome = runToEnd(action);
  EXPECT_EQ(outcome.output + outcome.error, "");
  return outcome.exitCode;
}

TEST(World, IsSteppedPlayedAndPaused) {
  const auto world = startServedWorld("pong_world.sdf", {"--paused"});
  EXPECT_EQ(ask({"step", "100"}), 0);
  EXPECT_TRUE(Regex("simulated 0\\.100 s, real \\d+\\.\\d{3} s, factor \\d+\\.\\d{3}, "
                    "100 iterations, paused\n")
                  .matches(state()))
      << state();
  EXPECT_EQ(ask({"step"}), 0);
  EXPECT_NE(state().find(" 101 iterations, paused"), std::string::npos);
  EXPECT_EQ(ask({"play"}), 0);
  EXPECT_NE(state().find(" iterations, running"), std::string::npos);
  EXPECT_EQ(ask({"pause"}), 0);
  EXPECT_EQ(ask({"step", "1"}), 0);
  EXPECT_NE(state().find(" iterations, paused"), std::string::npos);
}

TEST(World, EndsAfterItsIterationsOnceItIsPlayed) {
  const auto world = startServedWorld("pong_world.sdf", {"--paused", "--iterations", "50", "--hash"});
  EXPECT_EQ(ask({"play"}), 0);
  EXPECT_EQ(world->wait(), 0);
  const Outcome unpaused = runToEnd({"run", ownWorld("pong_world.sdf"), "-z", "0", "--iterations", "50", "--hash"});
  EXPECT_EQ(world->output(), unpaused.output);
}

TEST(World, IsChosenWhereSeveralRun) {
  const auto first = startServedWorld("pong_world.sdf", {"--paused"});
  EXPECT_EQ(ask({"pause", "-w", "pong_world"}), 0);
  const Outcome wrong = runToEnd({"world", "pause", "-w", "ping_world", "--timeout", "0"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.error, "pongsim: error: no world 'ping_world' is running\n  hint: did you mean 'pong_world'?\n");
  const auto second = startWorld("building_robot.sdf", {"--paused"});
  const Outcome list = runToEnd({"topic", "-et", "/world/building_robot/clock", "-n", "1"});
  EXPECT_EQ(list.exitCode, 0);
  const Outcome either = runToEnd({"world", "pause"});
  EXPECT_EQ(either.exitCode, 1);
  EXPECT_TRUE(either.error.starts_with("pongsim: error: several worlds are running: ")) << either.error;
}

TEST(World, TellsWhatIsInIt) {
  const auto world = startServedWorld("pong_world.sdf", {"--paused"});
  EXPECT_EQ(ask({"step", "20"}), 0);
  const Outcome info = runToEnd({"world", "info", "--timeout", "60000"});
  EXPECT_EQ(info.exitCode, 0) << info.error;
  EXPECT_EQ(info.output,
            "World: pong_world\n  models      3, 2 of them static\n  links       9\n  joints      3\n"
            "  sensors     0\n  lights      1\n  gravity     0 0 -9.8 m/s^2\n  step        0.001 s\n"
            "  simulated   0.020 s\n  iterations  20\n  state       paused\n");
  const Outcome json = runToEnd({"world", "stats", "-n", "1", "--json", "--timeout", "60000"});
  EXPECT_TRUE(Regex("\\{\"simulated\":0\\.02,\"real\":.*,\"iterations\":20,"
                    "\"paused\":true\\}\n")
                  .matches(json.output))
      << json.output;
}

TEST(World, StatsEndAtASignal) {
  const auto world = startServedWorld("pong_world.sdf");
  const auto stats = start({"world", "stats", "--timeout", "60000"});
  ASSERT_TRUE(stats->waitForOutput("running\n.*running\n")) << stats->error();
  stats->kill(SIGINT);
  EXPECT_EQ(stats->wait(), 0) << stats->error();
}

TEST(World, IsMissedWhereNoneRuns) {
  const Outcome none = runToEnd({"world", "play", "--timeout", "0"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_EQ(none.error, "pongsim: error: no world is running\n  hint: start one with pongsim run WORLD\n");
}

}  // namespace
}  // namespace pongsim::test
