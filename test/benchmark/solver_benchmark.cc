// Measures accuracy and cost of solvers: the tutorial's robot compared with the recorded paths of Fortress's engine,
// and the energy of a double pendulum. Prints the table of docs/physics.md.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/multi_body.hh"
#include "golden/corridor.hh"
#include "physics/engine.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"
#include "support/physics/rig.hh"

namespace pongsim::benchmark {
namespace {

constexpr double kStep = 1e-3;
constexpr double kWheelRadius = 0.4;
constexpr double kHalfSeparation = 0.6;
constexpr double kGravity = 9.8;

/// A world in one of the solvers.
struct World {
  std::function<void()> step;
  std::function<Vector3()> chassis = nullptr;
  /// Angle and rate of a joint, by its index in the file.
  std::function<std::pair<double, double>(int)> joint = nullptr;
};

struct Method {
  std::string name;
  /// @param left, right Velocities of the wheels [rad/s], if there are any.
  std::function<World(const description::World&, double left, double right)> begin;
};

Method engineWith(const std::string& name, const physics::Settings& settings) {
  return {name, [settings](const description::World& world, double left, double right) {
            auto rig = std::make_shared<test::Rig>(world, settings);
            const auto& joints = rig->entities.joints();
            for (world::Slot joint = 0; joint < joints.size(); ++joint) {
              const std::string& jointName = joints[joint].description->name;
              if (jointName == "left_wheel_joint") rig->engine.setJointVelocityTarget(joint, left);
              if (jointName == "right_wheel_joint") rig->engine.setJointVelocityTarget(joint, right);
            }
            const world::Slot chassis = rig->entities.findLink("vehicle_blue::chassis");
            return World{[rig] { rig->step(); },
                         [rig, chassis] { return rig->state.links[chassis].X_WorldLink.position; },
                         [rig](int joint) {
                           const world::JointState& state = rig->joint(static_cast<world::Slot>(joint));
                           return std::pair(state.position, state.velocity);
                         }};
          }};
}

Method multiBodyWith(int iterations) {
  return {"btMultiBody, " + std::to_string(iterations) + " iterations",
          [iterations](const description::World& world, double left, double right) {
            auto bodies = std::make_shared<MultiBodyWorld>(world, iterations);
            bodies->setVelocity("left_wheel_joint", left);
            bodies->setVelocity("right_wheel_joint", right);
            return World{[bodies] { bodies->step(kStep); }, [bodies] { return bodies->basePosition(); },
                         [bodies](int joint) { return std::pair(bodies->angle(joint), bodies->rate(joint)); }};
          }};
}

std::vector<Method> methods() {
  using physics::Solver;
  const auto with = [](Solver solver, int iterations) {
    physics::Settings settings;
    settings.solver = solver;
    settings.iterations = iterations;
    return settings;
  };
  std::vector<Method> all;
  for (const int count : {10, 20, 50, 200}) {
    all.push_back(engineWith("Gauss-Seidel, " + std::to_string(count), with(Solver::kGaussSeidel, count)));
  }
  for (const int count : {10, 50, 200}) all.push_back(multiBodyWith(count));
  all.push_back(engineWith("direct", {}));
  return all;
}

struct Deviation {
  /// [m]
  double atEnd = 0;
  double largest = 0;
  /// Time per step [us]: the minimum of ten.
  double cost = 1e9;
};

/// @return NaN if the robot flies apart.
Deviation drive(const Method& method, const description::World& world, const std::string& file, double linear,
                double angular) try {
  const double turning = angular * kHalfSeparation;
  const World run = method.begin(world, (linear - turning) / kWheelRadius, (linear + turning) / kWheelRadius);
  Deviation found;
  long steps = 0;
  auto start = std::chrono::steady_clock::now();
  for (const test::Sample& sample : test::readSamples(*test::goldenData() / file)) {
    for (; static_cast<double>(steps) * kStep < toSeconds(sample.time) - kStep / 2; ++steps) {
      if (steps % 1000 == 0) start = std::chrono::steady_clock::now();
      run.step();
      if (steps % 1000 != 999) continue;
      const auto time = std::chrono::steady_clock::now() - start;
      found.cost = std::min(found.cost, std::chrono::duration<double, std::micro>(time).count() / 1000);
    }
    found.atEnd = (run.chassis() - sample.position).norm();
    found.largest = std::max(found.largest, found.atEnd);
  }
  return found;
} catch (const std::runtime_error&) {
  return {std::nan(""), std::nan("")};
}

/// Two rods of 1 m and 1 kg, initially horizontal.
description::World doublePendulum() {
  std::vector<description::Link> rods;
  for (int i = 0; i < 2; ++i) {
    rods.push_back(test::makeLink("rod" + std::to_string(i), {0.5 + i, 0, 0}, 1, {0.01, 1.0 / 12, 1.0 / 12}));
  }
  description::Model model = test::makeModel("pendulum", rods);
  const auto hinge = [](const char* name, const char* parent, const char* child, const Pose& X_ParentJoint) {
    return test::makeJoint(name, description::JointType::kRevolute, parent, child, X_ParentJoint, test::at(-0.5, 0, 0),
                           Vector3::UnitY());
  };
  model.joints = {hinge("j0", "world", "rod0", Pose()), hinge("j1", "rod0", "rod1", test::at(0.5, 0, 0))};
  description::World world;
  world.gravity = {0, 0, -kGravity};
  world.models = {model};
  return world;
}

/// [J]
double energyOf(const World& run) {
  const auto [angle, rate] = run.joint(0);
  const auto [bend, bendRate] = run.joint(1);
  const double second = angle + bend;
  const double secondRate = rate + bendRate;
  const double vx = -std::sin(angle) * rate - 0.5 * std::sin(second) * secondRate;
  const double vz = -std::cos(angle) * rate - 0.5 * std::cos(second) * secondRate;
  const double height = -1.5 * std::sin(angle) - 0.5 * std::sin(second);
  return rate * rate / 6 + secondRate * secondRate / 24 + (vx * vx + vz * vz) / 2 + kGravity * height;
}

/// @return Relative loss of energy in a minute, averaged over a second; NaN if the pendulum flies apart.
double pendulumDrift(const Method& method) try {
  const World run = method.begin(doublePendulum(), 0, 0);
  double first = 0;
  double last = 0;
  for (int i = 0; i < 60000; ++i) {
    run.step();
    if (i < 1000) first += energyOf(run) / 1000;
    if (i >= 59000) last += energyOf(run) / 1000;
  }
  return (first - last) / (kGravity * 2);
} catch (const std::runtime_error&) {
  return std::nan("");
}

int run() {
  const auto worlds = test::fortressWorlds();
  if (!worlds || !test::goldenData()) throw std::runtime_error("needs Fortress's worlds and its recorded paths");
  Diagnostics diagnostics;
  const sdf::Root root = sdf::loadFile(*worlds / "tutorials" / "moving_robot.sdf", diagnostics);
  if (diagnostics.hasErrors()) throw std::runtime_error(format(diagnostics.all().front()));
  std::printf("deviation from Fortress's engine after 10 s, and the largest until then [mm]; cost of a step [us]\n");
  std::printf("%-28s %15s %15s %15s %8s %18s\n", "solver", "bend", "straight", "on the spot", "cost",
              "pendulum lost [%]");
  for (const Method& method : methods()) {
    double cost = 1e9;
    std::printf("%-28s", method.name.c_str());
    const auto print = [&](const std::string& file, double linear, double angular) {
      const Deviation found = drive(method, root.worlds.front(), file, linear, angular);
      cost = std::min(cost, found.cost);
      std::printf("   %5.1f %5.1f  ", 1000 * found.atEnd, 1000 * found.largest);
    };
    print("drive_v0.5_w0.05.csv", 0.5, 0.05);
    print("drive_v0.5_w0.csv", 0.5, 0);
    print("drive_v0_w0.5.csv", 0, 0.5);
    std::printf(" %8.1f %18.3f\n", cost, 100 * pendulumDrift(method));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main() {
  try {
    return pongsim::benchmark::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "solver benchmark: error: %s\n", error.what());
    return 1;
  }
}
