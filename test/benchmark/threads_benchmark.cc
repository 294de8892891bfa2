// Measures the gain from threads: within a world, and for worlds in parallel.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "benchmark/robots.hh"
#include "benchmark/shapes_world.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

constexpr int kRounds = 15;
constexpr int kShapes = 3000;

/// A world to measure.
struct Case {
  std::string name;
  std::string text;
  /// Number of steps before the measurement, and per measurement.
  std::uint64_t skipped;
  std::uint64_t steps;
  bool isDriven;
};

std::string worldWith(int robots) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) throw std::runtime_error("needs the tutorial worlds of Fortress");
  std::ifstream stream(*worlds / "tutorials" / "moving_robot.sdf");
  return withRobots({std::istreambuf_iterator<char>(stream), {}}, robots);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int robots : {1, 10, 50, 200, 1000}) {
    const auto steps = static_cast<std::uint64_t>(std::max(20, 20'000 / robots));
    all.push_back({std::to_string(robots) + (robots == 1 ? " robot" : " robots"), worldWith(robots), 0, steps, true});
  }
  all.push_back({"shapes that fall", worldOfShapes(kShapes, true), 0, 40, false});
  all.push_back({"shapes that roll", worldOfShapes(kShapes, true), 2000, 40, false});
  all.push_back({"shapes that land", worldOfShapes(kShapes, false), 0, 40, false});
  return all;
}

std::unique_ptr<Simulation> load(const Case& what, int threads) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(what.text, "threads.sdf", {.threads = threads}, diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  if (what.isDriven) driveOff(*simulation);
  simulation->step(what.skipped);
  return simulation;
}

/// @return Wall time of one call [us].
double timeOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

double medianOf(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Prints the time of a step for each number of threads, measured in turns.
void compareThreads(const Case& what, const std::vector<int>& counts) {
  std::vector<std::unique_ptr<Simulation>> simulations;
  for (const int threads : counts) simulations.push_back(load(what, threads));
  std::vector<std::vector<double>> times(simulations.size());
  std::vector<std::vector<double>> gains(simulations.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < simulations.size(); ++i) {
      times[i].push_back(timeOf([&] { simulations[i]->step(what.steps); }) / static_cast<double>(what.steps));
      gains[i].push_back(times[0].back() / times[i].back());
    }
  }
  for (std::size_t i = 0; i < simulations.size(); ++i) {
    const std::uint64_t hash = simulations[i]->stateHash();
    const double time = medianOf(times[i]);
    std::printf("%-18s %6d %14.1f %10.0f %8.2f  %016llx%s\n", what.name.c_str(), counts[i], time, 1e6 / time,
                medianOf(gains[i]), static_cast<unsigned long long>(hash),
                hash == simulations[0]->stateHash() ? "" : "   other bits!");
    std::fflush(stdout);
  }
}

/// Prints how many steps two worlds in parallel, each on its own thread, make compared with one.
void compareWorlds(const Case& what) {
  const auto first = load(what, 1), second = load(what, 1);
  std::vector<double> gains;
  for (int round = 0; round < kRounds; ++round) {
    const double alone = timeOf([&] { first->step(what.steps); });
    const double both = timeOf([&] {
      std::thread other([&] { second->step(what.steps); });
      first->step(what.steps);
      other.join();
    });
    gains.push_back(2 * alone / both);
  }
  std::printf("%-18s %10.2f\n", what.name.c_str(), medianOf(gains));
}

int run() {
  const int cores = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> counts;
  for (const int threads : {1, 2, 4, 8}) {
    if (threads <= cores) counts.push_back(threads);
  }
  const std::vector<Case> all = cases();
  std::printf("one world on some threads, medians of %d\n%-18s %6s %14s %10s %8s  %s\n", kRounds, "world", "threads",
              "a step [us]", "steps/s", "gain", "state at the end");
  for (const Case& each : all) compareThreads(each, counts);
  std::printf("\ntwo worlds, each on a thread of its own, against one\nworld              gain\n");
  for (std::size_t i = 0; i < 3; ++i) compareWorlds(all[i]);
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main() {
  try {
    return pongsim::benchmark::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "threads benchmark: error: %s\n", error.what());
    return 1;
  }
}
