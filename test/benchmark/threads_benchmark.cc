// What threads gain: within a world, and for worlds side by side.

#include <algorithm>
#include <chrono>
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
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

constexpr int kRounds = 15;

std::string worldWith(int robots) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) throw std::runtime_error("needs the tutorial worlds of Fortress");
  std::ifstream stream(*worlds / "tutorials" / "moving_robot.sdf");
  return withRobots({std::istreambuf_iterator<char>(stream), {}}, robots);
}

std::unique_ptr<Simulation> driving(const std::string& world, int threads) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(world, "robots.sdf", {.threads = threads}, diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  driveOff(*simulation);
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

/// Prints what a step takes on each number of threads, measured by turns.
void compareThreads(int robots, int most) {
  const std::string world = worldWith(robots);
  const int steps = std::max(20, 20'000 / robots);
  std::vector<std::unique_ptr<Simulation>> simulations;
  for (int threads = 1; threads <= most; ++threads) simulations.push_back(driving(world, threads));
  std::vector<std::vector<double>> times(simulations.size());
  std::vector<std::vector<double>> gains(simulations.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < simulations.size(); ++i) {
      times[i].push_back(timeOf([&] { simulations[i]->step(static_cast<std::uint64_t>(steps)); }) / steps);
      gains[i].push_back(times[0].back() / times[i].back());
    }
  }
  for (std::size_t i = 0; i < simulations.size(); ++i) {
    std::printf("%6d %8zu %14.1f %10.2f%s\n", robots, i + 1, medianOf(times[i]), medianOf(gains[i]),
                simulations[i]->stateHash() == simulations[0]->stateHash() ? "" : "   other bits!");
  }
}

/// Prints how many steps two worlds make at once, each on a thread of its own, for those that one makes.
void compareWorlds(int robots) {
  const std::string world = worldWith(robots);
  const auto steps = static_cast<std::uint64_t>(std::max(20, 20'000 / robots));
  const auto first = driving(world, 1), second = driving(world, 1);
  std::vector<double> gains;
  for (int round = 0; round < kRounds; ++round) {
    const double alone = timeOf([&] { first->step(steps); });
    const double both = timeOf([&] {
      std::thread other([&] { second->step(steps); });
      first->step(steps);
      other.join();
    });
    gains.push_back(2 * alone / both);
  }
  std::printf("%6d %10.2f\n", robots, medianOf(gains));
}

int run() {
  const int cores = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  std::printf("one world on some threads, medians of %d\nrobots  threads  a step [us]       gain\n", kRounds);
  for (const int robots : {1, 10, 50, 200}) compareThreads(robots, std::min(cores, 8));
  std::printf("\ntwo worlds, each on a thread of its own, against one\nrobots       gain\n");
  for (const int robots : {1, 10, 50}) compareWorlds(robots);
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
