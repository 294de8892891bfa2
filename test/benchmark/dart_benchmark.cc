// Compares cost and accuracy of a step with DART through ign-physics, the engine of Fortress's server, on the same
// worlds in the same run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/dart_world.hh"
#include "benchmark/medians.hh"
#include "benchmark/robots.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

constexpr double kStep = 0.001;
// wheels of the tutorial's robot [m]
constexpr double kRadius = 0.4, kHalfSeparation = 0.6;

struct Case {
  std::string name;
  std::string text;
  /// Whether there are driving robots; everything else rests.
  bool drives = true;
};

std::vector<Case> cases() {
  const auto worlds = test::fortressWorlds();
  if (!worlds) throw std::runtime_error("the worlds of Fortress are not here");
  const auto textOf = [&](const char* file) {
    std::ifstream stream(*worlds / file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string robot = textOf("tutorials/moving_robot.sdf");
  std::vector<Case> result = {{"moving_robot", robot}};
  for (const int count : {10, 50})
    result.push_back({"moving_robot_x" + std::to_string(count), withRobots(robot, count)});
  result.push_back({"shapes", textOf("examples/shapes.sdf"), false});
  return result;
}

std::unique_ptr<Simulation> load(const Case& which) {
  Diagnostics diagnostics;
  auto simulation = Simulation::fromText(which.text, which.name, SimulationOptions(), diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  return simulation;
}

/// @param angular Turning rate of the robots, if any [rad/s].
DartWorld loadInDart(const Case& which, double angular) {
  DartWorld world(which.text);
  if (which.drives) {
    world.setVelocity("left_wheel_joint", (kLinear - angular * kHalfSeparation) / kRadius);
    world.setVelocity("right_wheel_joint", (kLinear + angular * kHalfSeparation) / kRadius);
  }
  return world;
}

void stepDart(::benchmark::State& run, const Case& which) {
  DartWorld world = loadInDart(which, kAngular);
  const auto chassis = [&] { return which.drives ? world.position("vehicle_blue", "chassis") : Vector3(); };
  const Vector3 start = chassis();
  for (int i = 0; i < kSettlingSteps; ++i) world.step(kStep);
  if (which.drives) requireMoved((chassis() - start).norm());
  for (auto _ : run) world.step(kStep);
}

void stepSimulation(::benchmark::State& run, const Case& which) {
  const auto simulation = load(which);
  if (which.drives) {
    driveOff(*simulation);
  } else {
    simulation->step(kSettlingSteps);
  }
  for (auto _ : run) simulation->step();
}

/// Errors of both after five seconds [m].
struct Errors {
  double pongsim = 0;
  double dart = 0;
};

/// Error of the distance that a robot drives straight ahead, compared with its wheels.
Errors errorsOfDriving(const Case& which) {
  constexpr double kSeconds = 5;
  constexpr double kTruth = kLinear * kSeconds;
  const auto steps = static_cast<int>(kSeconds / kStep);
  DartWorld world = loadInDart(which, 0);
  const auto simulation = load(which);
  driveOff(*simulation, 0);
  for (int i = 0; i < kSettlingSteps; ++i) world.step(kStep);
  const Link chassis = chassisOf(*simulation);
  const Vector3 start = chassis.pose().position, startInDart = world.position("vehicle_blue", "chassis");
  simulation->step(steps);
  for (int i = 0; i < steps; ++i) world.step(kStep);
  return {std::abs((chassis.pose().position - start).norm() - kTruth),
          std::abs((world.position("vehicle_blue", "chassis") - startInDart).norm() - kTruth)};
}

/// Error of the heights at which bodies rest.
Errors errorsOfResting(const Case& which) {
  constexpr double kHeight = 0.5;
  constexpr int kSteps = 5000;
  DartWorld world = loadInDart(which, 0);
  const auto simulation = load(which);
  simulation->step(kSteps);
  for (int i = 0; i < kSteps; ++i) world.step(kStep);
  Errors errors;
  for (const std::string name : {"box", "cylinder", "sphere"}) {
    const auto link = simulation->world().model(name)->link(name + "_link");
    errors.pongsim = std::max(errors.pongsim, std::abs(link->pose().position.z() - kHeight));
    errors.dart = std::max(errors.dart, std::abs(world.position(name, name + "_link").z() - kHeight));
  }
  return errors;
}

int run(int argc, char** argv) {
  const std::vector<Case> all = cases();
  for (const Case& which : all) {
    const auto add = [&](const char* what, auto function) {
      ::benchmark::RegisterBenchmark((which.name + "/" + what).c_str(), function, which)
          ->Unit(::benchmark::kMicrosecond);
    };
    add("simulation", stepSimulation);
    add("dart", stepDart);
  }
  Medians medians;
  if (!medians.run(argc, argv)) return 2;
  std::printf("\nsimulation: the whole of pongsim, systems included; dart: Fortress's engine alone\n");
  std::printf("%-18s %15s %10s %18s %18s %15s\n", "world", "simulation [us]", "dart [us]", "dart : simulation",
              "error, pongsim [m]", "error, dart [m]");
  for (const Case& which : all) {
    const double simulation = medians.of(which.name + "/simulation"), dart = medians.of(which.name + "/dart");
    if (!(simulation > 0 && dart > 0)) continue;
    const Errors errors = which.drives ? errorsOfDriving(which) : errorsOfResting(which);
    std::printf("%-18s %15.2f %10.2f %18.2f %18.6f %15.6f\n", which.name.c_str(), simulation, dart, dart / simulation,
                errors.pongsim, errors.dart);
  }
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) { return pongsim::benchmark::run(argc, argv); }
