#include "trouble.hh"

#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "calls.hh"
#include "kinds.hh"
#include "peers.hh"
#include "pongsim/node.hh"

namespace pongsim::benchmark {

namespace {

using test::Process;

void printCalls(const char* name, const Calls& calls) {
  std::printf("  %-27s %s, %d waited, %d pushed away\n", name, summary(calls.took).c_str(), calls.waits, calls.pushes);
}

/// Takes about as long as a write without disturbance.
void doNothing() {
  const auto end = Clock::now() + std::chrono::microseconds(10);
  while (Clock::now() < end) continue;
}

/// Other processes that disturb the publisher.
struct Disturbance {
  std::vector<std::unique_ptr<Process>> processes;
  /// Called repeatedly on a thread of its own.
  std::function<void()> trouble;
};

/// Measurements of four seconds.
struct Window {
  Calls writes;
  /// Calls of `doNothing` between the writes: their delays are due to the machine.
  Calls nothing;
  std::uint64_t came = 0;
  std::uint64_t dropped = 0;
};

/// Publishes a Twist at 1 kHz.
Window measureBeside(Disturbance disturbance) {
  Window window;
  pongsim::Transport transport;
  const auto subscription =
      transport.node().subscribe<ignition::msgs::Int32>(kFloodTopic, [](const ignition::msgs::Int32&) {});
  auto publisher = transport.node().advertise<ignition::msgs::Twist>(kTopic);
  if (!disturbance.processes.empty()) publisher.waitForSubscribers(std::chrono::seconds(2));
  std::atomic<bool> isOver = false;
  std::thread troubled([&] {
    while (!isOver && disturbance.trouble) disturbance.trouble();
  });
  ignition::msgs::Twist message;
  window.writes = publishAt(
      1000, 4000,
      [&] {
        stamp(message);
        publisher.publish(message);
      },
      [&] {
        window.nothing.measure(doNothing);
        transport.dispatch();
      });
  isOver = true;
  troubled.join();
  window.came = subscription.received();
  window.dropped = subscription.dropped();
  for (auto& each : disturbance.processes) {
    each->kill(SIGTERM);
    each->kill(SIGCONT);
    each->wait();
  }
  return window;
}

/// Measures several windows, and prints the one in which `doNothing` was delayed least.
void measureTrouble(const char* name, const std::function<Disturbance()>& meet) {
  constexpr int kMostWindows = 6;
  constexpr double kQuiet = 40;
  Window quietest;
  double least = 0;
  int windows = 0;
  while (windows < kMostWindows && (windows == 0 || least > kQuiet)) {
    Window window = measureBeside(meet());
    const double held = quantile(window.nothing.took, 0.999);
    if (windows++ > 0 && held >= least) continue;
    least = held;
    quietest = std::move(window);
  }
  printCalls(name, quietest.writes);
  printCalls("  10 us of nothing", quietest.nothing);
  std::printf("    the quietest of %d windows", windows);
  if (quietest.came > 0) {
    std::printf("; %llu messages came meanwhile, %llu were dropped", static_cast<unsigned long long>(quietest.came),
                static_cast<unsigned long long>(quietest.dropped));
  }
  std::printf("\n");
  std::fflush(stdout);
}

Disturbance oneListener(int pause = 0) {
  Disturbance disturbance;
  disturbance.processes.push_back(listener("pongsim", 0, 1'000'000, pause));
  return disturbance;
}

Disturbance stoppedListener() {
  Disturbance disturbance = oneListener();
  disturbance.trouble = [pid = disturbance.processes.front()->pid()] {
    kill(pid, SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  return disturbance;
}

Disturbance killedListeners() {
  Disturbance disturbance;
  disturbance.processes.push_back(other("kill"));
  return disturbance;
}

Disturbance flooder() {
  Disturbance disturbance = oneListener();
  disturbance.processes.push_back(other("flood"));
  return disturbance;
}

}  // namespace

void measureTroubles() {
  std::printf("publishing a Twist at 1 kHz, each of 4,000 times\n");
  measureTrouble("nobody listens", [] { return Disturbance(); });
  measureTrouble("one listens", [] { return oneListener(); });
  measureTrouble("one takes 20 ms a message", [] { return oneListener(20); });
  measureTrouble("one is stopped", stoppedListener);
  measureTrouble("one after another is killed", killedListeners);
  measureTrouble("one sends 100,000 a second", flooder);
}

}  // namespace pongsim::benchmark
