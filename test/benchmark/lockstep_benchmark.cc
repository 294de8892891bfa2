// Measures a tick in lockstep with a controller in another process that answers at once, compared with a round trip of
// the same messages between two processes without a world. Medians of alternating rounds.
//   pongsim_lockstep_bench                   all measurements
//   pongsim_lockstep_bench echo              the other process: answers each clock with a Twist

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"
#include "sim/running/runner.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "transport/calls.hh"

namespace {

using namespace pongsim::benchmark;
using ignition::msgs::Twist;

constexpr int kTicks = 2000;
constexpr int kRounds = 5;
constexpr const char* kAnswer = "/cmd_vel";

volatile std::sig_atomic_t stopping = 0;

int echo() {
  std::signal(SIGTERM, [](int) { stopping = 1; });
  pongsim::Transport transport;
  pongsim::Publisher answers = transport.node().advertise<Twist>(kAnswer);
  // only then it hears the clock: who hears it can answer
  while (stopping == 0 && !answers.waitForSubscribers(std::chrono::milliseconds(20))) continue;
  const pongsim::Subscription clock =
      transport.node().subscribe<ignition::msgs::Clock>("/clock", [&](const ignition::msgs::Clock& message) {
        Twist twist;
        twist.mutable_linear()->set_x(static_cast<double>(message.sim().nsec()));
        answers.publish(twist);
      });
  while (stopping == 0) transport.dispatchFor(std::chrono::milliseconds(20));
  return 0;
}

std::unique_ptr<pongsim::test::Process> echoing() {
  return std::make_unique<pongsim::test::Process>(std::vector<std::string>{"/proc/self/exe", "echo"});
}

/// @return Median of the durations of round trips [us].
double roundTrip() {
  const auto other = echoing();
  pongsim::Transport transport;
  pongsim::Publisher clock = transport.node().advertise<ignition::msgs::Clock>("/clock");
  int answers = 0;
  const pongsim::Subscription answer = transport.node().subscribe<Twist>(kAnswer, [&](const Twist&) { ++answers; });
  transport.waitForTopic(kAnswer, true, pongsim::test::kDeadline);
  clock.waitForSubscribers(pongsim::test::kDeadline);
  std::vector<Microseconds> took;
  for (int i = 0; i < kTicks; ++i) {
    ignition::msgs::Clock message;
    message.mutable_sim()->set_nsec(i);
    const auto begin = Clock::now();
    clock.publish(message);
    while (answers <= i) transport.dispatchFor(std::chrono::seconds(1));
    took.push_back(Clock::now() - begin);
  }
  other->kill(SIGTERM);
  other->wait();
  return quantile(took, 0.5);
}

/// @param inLockstep Otherwise its steps alone.
/// @return Median of the durations of steps [us].
double tick(bool inLockstep) {
  const auto other = inLockstep ? echoing() : nullptr;
  pongsim::Transport transport;
  pongsim::Diagnostics diagnostics;
  const auto world = pongsim::Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "world",
                                                   {.loadSystems = false, .transport = &transport}, diagnostics);
  std::vector<Microseconds> took;
  auto last = Clock::now();
  pongsim::sim::RunOptions options{.iterations = kTicks, .updateRate = 0.0};
  options.stepped = [&](pongsim::Simulation&) {
    const auto now = Clock::now();
    took.push_back(now - last);
    last = now;
    return true;
  };
  if (inLockstep) options.lockstep = pongsim::LockstepOptions{.topics = {{kAnswer}}, .heard = {"/clock"}};
  pongsim::sim::Runner runner(*world, options);
  runner.run();
  if (other) {
    other->kill(SIGTERM);
    other->wait();
  }
  return quantile(took, 0.5);
}

}  // namespace

int main(int count, char** texts) {
  if (count == 2 && std::string(texts[1]) == "echo") return echo();
  if (count > 1) {
    std::fprintf(stderr, "pongsim_lockstep_bench: error: takes no options\n");
    return 2;
  }
  // sets the domain of this process and of those that it starts
  pongsim::test::testDomain();
  std::vector<double> ratios;
  for (int round = 0; round < kRounds; ++round) {
    const double trip = roundTrip();
    const double inLockstep = tick(true);
    const double alone = tick(false);
    ratios.push_back(inLockstep / trip);
    std::printf("round trip %6.1f us, tick in lockstep %6.1f us (%.2f round trips), step alone %.1f us\n", trip,
                inLockstep, ratios.back(), alone);
    std::fflush(stdout);
  }
  std::ranges::sort(ratios);
  std::printf("a tick takes %.2f round trips (median of %d rounds)\n", ratios[kRounds / 2], kRounds);
  return 0;
}
