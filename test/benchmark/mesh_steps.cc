#include "benchmark/mesh_steps.hh"

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "physics/hulls/hull_store.hh"
#include "support/physics/rig.hh"
#include "support/solids.hh"
#include "support/temp_folder.hh"

namespace pongsim::benchmark {

namespace {

description::Mesh meshWith(description::TriangleMesh triangles) {
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const description::TriangleMesh>(std::move(triangles));
  return mesh;
}

description::World bowls(description::MeshOptimization optimization, bool haveBalls) {
  description::Mesh bowl = meshWith(test::bowl(0.2, 0.02, 50, 24));
  bowl.optimization = optimization;
  bowl.maxConvexHulls = 64;
  description::World world;
  world.models.push_back(test::makeGround());
  for (int i = 0; i < 10; ++i) {
    description::Link shell = test::makeLink("link", {i * 1.0, 0, 0.2}, 2, {0.04, 0.04, 0.04});
    shell.inertial.X_LinkCom.position = {0, 0, -0.15};
    test::addCollision(shell, bowl);
    description::Link ball = test::makeLink("link", {i * 1.0, 0, 0.3}, 0.2, {2e-4, 2e-4, 2e-4});
    test::addCollision(ball, description::Sphere{0.05});
    world.models.push_back(test::makeModel("bowl" + std::to_string(i), {shell}));
    if (haveBalls) world.models.push_back(test::makeModel("ball" + std::to_string(i), {ball}));
  }
  return world;
}

/// @param number Varies the ring, so that no two are the same.
description::TriangleMesh ring(int number) {
  std::vector<std::pair<double, double>> line;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    line.emplace_back(1 + 0.01 * number + 0.3 * std::cos(angle), 0.3 * std::sin(angle));
  }
  return test::turned(line, 64);
}

}  // namespace

void stepBowls(::benchmark::State& run, description::MeshOptimization optimization, bool haveBalls) {
  test::Rig rig(bowls(optimization, haveBalls));
  rig.step(1000);
  if (haveBalls && rig.link("ball0::link").X_WorldLink.position.z() > 0.1) throw std::runtime_error("no bowl");
  for (auto _ : run) rig.step();
}

void startMeshes(::benchmark::State& run, bool isWarm) {
  std::vector<physics::HullRequest> requests;
  for (int i = 0; i < 5; ++i) {
    requests.push_back(physics::requestFor(meshWith(test::bowl(0.2, 0.01 + 0.001 * i, 50, 25))));
    requests.push_back(physics::requestFor(meshWith(ring(i))));
  }
  const test::TempFolder folder;
  if (isWarm) physics::HullStore(folder.path()).prepare(requests);
  for (auto _ : run) physics::HullStore(isWarm ? folder.path() : std::filesystem::path()).prepare(requests);
}

}  // namespace pongsim::benchmark
