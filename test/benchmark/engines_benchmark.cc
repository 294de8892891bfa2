// Worlds that step on request and print the cost; test/benchmark/profile.py profiles them.

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "benchmark/robots.hh"
#include "benchmark/shapes_world.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

std::unique_ptr<Simulation> load(const std::string& text) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(text, "engines.sdf", {}, diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  return simulation;
}

std::string tutorialWorld() {
  const auto worlds = test::fortressWorlds();
  if (!worlds) throw std::runtime_error("needs the tutorial worlds of Fortress");
  std::ifstream stream(*worlds / "tutorials" / "moving_robot.sdf");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// @return Processor time of this process so far [us].
double processorTime() { return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Reads numbers of steps from stdin, makes so many each time, and prints their processor time [us].
void serve(Simulation& simulation) {
  std::puts("ready");
  std::fflush(stdout);
  for (std::uint64_t steps = 0; std::cin >> steps;) {
    const double start = processorTime();
    simulation.step(steps);
    std::printf("%.3f\n", processorTime() - start);
    std::fflush(stdout);
  }
}

int run(const std::string& what, int count) {
  if (what == "robots") {
    const auto simulation = load(withRobots(tutorialWorld(), count));
    driveOff(*simulation);
    serve(*simulation);
  } else {
    const auto simulation = load(worldOfShapes(count, what == "falling"));
    serve(*simulation);
  }
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::invalid_argument("wants what (robots, shapes, falling) and how many");
    return pongsim::benchmark::run(argv[1], std::stoi(argv[2]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "engines benchmark: error: %s\n", error.what());
    return 1;
  }
}
