// Measures the cost of a step, compared with a bare Bullet loop of the same world in the same run.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/bare_bullet.hh"
#include "benchmark/medians.hh"
#include "benchmark/mesh_steps.hh"
#include "benchmark/robots.hh"
#include "physics/engine.hh"
#include "pongsim/simulation.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::benchmark {
namespace {

constexpr double kStep = 0.001;
constexpr double kLeft = (kLinear - kAngular * 0.6) / 0.4;
constexpr double kRight = (kLinear + kAngular * 0.6) / 0.4;

struct Case {
  std::string name;
  std::string text;
};

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Case> cases() {
  std::vector<Case> result = {{"pong_world", textOf(test::projectFolder() / "worlds" / "pong_world.sdf")}};
  if (const auto worlds = test::fortressWorlds()) {
    const std::string text = textOf(*worlds / "tutorials" / "moving_robot.sdf");
    result.push_back({"moving_robot", text});
    for (const int count : {10, 50, 200}) {
      result.push_back({"moving_robot_x" + std::to_string(count), withRobots(text, count)});
    }
  }
  return result;
}

description::World load(const Case& which) {
  Diagnostics diagnostics;
  sdf::Root root = sdf::loadText(which.text, which.name, diagnostics);
  if (diagnostics.hasErrors()) throw std::runtime_error(format(diagnostics.all().front()));
  return std::move(root.worlds.front());
}

void stepBare(::benchmark::State& run, const Case& which, BareSolver solver) {
  BareBullet world(load(which), solver);
  world.setVelocity("left_wheel_joint", kLeft);
  world.setVelocity("right_wheel_joint", kRight);
  const btVector3 start = world.position("chassis");
  for (int i = 0; i < kSettlingSteps; ++i) world.step(kStep);
  requireMoved((world.position("chassis") - start).length());
  for (auto _ : run) world.step(kStep);
}

world::Slot chassisOf(const world::Entities& entities) {
  for (world::Slot link = 0; link < entities.links().size(); ++link) {
    if (entities.links()[link].description->name == "chassis") return link;
  }
  throw std::runtime_error("no robot here");
}

void stepEngine(::benchmark::State& run, const Case& which) {
  const description::World description = load(which);
  const world::Entities entities(description);
  world::State state(entities);
  physics::Engine engine(entities);
  for (world::Slot joint = 0; joint < entities.joints().size(); ++joint) {
    const std::string& name = entities.joints()[joint].description->name;
    if (name == "left_wheel_joint") engine.setJointVelocityTarget(joint, kLeft);
    if (name == "right_wheel_joint") engine.setJointVelocityTarget(joint, kRight);
  }
  const Time dt = fromSeconds(kStep);
  const world::LinkState& chassis = state.links[chassisOf(entities)];
  const Vector3 start = chassis.X_WorldLink.position;
  for (int i = 0; i < kSettlingSteps; ++i) engine.step(dt, state);
  requireMoved((chassis.X_WorldLink.position - start).norm());
  for (auto _ : run) engine.step(dt, state);
}

void stepSimulation(::benchmark::State& run, const Case& which) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(which.text, which.name, SimulationOptions(), diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  driveOff(*simulation);
  for (auto _ : run) simulation->step();
}

void printTable(const Medians& medians, const std::vector<Case>& all) {
  std::printf("\nbare: a loop of Bullet with pongsim's solver; stock: with Bullet's own, as it comes\n");
  std::printf("%-18s %10s %10s %11s %15s %14s %17s %18s\n", "world", "bare [us]", "stock [us]", "engine [us]",
              "simulation [us]", "engine : bare", "simulation : bare", "simulation : stock");
  for (const Case& which : all) {
    const auto median = [&](const char* what) { return medians.of(which.name + "/" + what); };
    const double bare = median("bare"), stock = median("stock");
    const double engine = median("engine"), simulation = median("simulation");
    if (!(bare > 0 && stock > 0 && engine > 0 && simulation > 0)) continue;
    std::printf("%-18s %10.2f %10.2f %11.2f %15.2f %14.2f %17.2f %18.2f\n", which.name.c_str(), bare, stock, engine,
                simulation, engine / bare, simulation / bare, simulation / stock);
  }
}

void addMeshes() {
  using description::MeshOptimization;
  const auto add = [](const char* name, MeshOptimization optimization, bool haveBalls) {
    ::benchmark::RegisterBenchmark(name, stepBowls, optimization, haveBalls)->Unit(::benchmark::kMicrosecond);
  };
  add("bowls_x10/hulls", MeshOptimization::kConvexHull, false);
  add("bowls_x10/pieces", MeshOptimization::kNone, false);
  add("bowls_x10/pieces_and_balls", MeshOptimization::kNone, true);
  for (const auto& [name, isWarm] :
       {std::pair("start_of_meshes_x10/cold", false), std::pair("start_of_meshes_x10/warm", true)}) {
    ::benchmark::RegisterBenchmark(name, startMeshes, isWarm)->Unit(::benchmark::kMillisecond)->UseRealTime();
  }
}

int run(int argc, char** argv) {
  const std::vector<Case> all = cases();
  for (const Case& which : all) {
    const auto add = [&](const char* what, auto function) {
      ::benchmark::RegisterBenchmark((which.name + "/" + what).c_str(), function, which)
          ->Unit(::benchmark::kMicrosecond);
    };
    add("bare", [](auto& state, const Case& each) { stepBare(state, each, BareSolver::kPongsim); });
    add("stock", [](auto& state, const Case& each) { stepBare(state, each, BareSolver::kBullet); });
    add("engine", stepEngine);
    add("simulation", stepSimulation);
  }
  addMeshes();
  Medians medians;
  if (!medians.run(argc, argv)) return 2;
  printTable(medians, all);
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) { return pongsim::benchmark::run(argc, argv); }
