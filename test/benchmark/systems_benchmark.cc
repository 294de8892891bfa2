// Measures the cost of each system per step without subscribers, the cost of fifty driven robots in addition to the
// physics, and that of robots in unloaded levels.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/medians.hh"
#include "pongsim/message.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"
#include "support/working_folder.hh"

namespace pongsim::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr int kRobots = 50;
constexpr int kBodies = 100;
constexpr int kRobotsALevel = 10, kRobotsInLevels = 500;
constexpr double kMostForLevels = 0.05;
constexpr double kMostMicroseconds = 2;
constexpr double kMostShare = 0.1;
constexpr int kSettlingSteps = 500;
// steps of acceleration: 2 m/s^2 up to 0.5 m/s
constexpr int kRampSteps = 250;
// least distance after these steps [m]
constexpr double kLeastWay = 0.12;
// the commanded Twist; wheels have a radius of 0.1 m and are 0.4 m apart
constexpr double kLinear = 0.5, kAngular = 0.3;
constexpr double kLeftWheel = (kLinear - kAngular * 0.2) / 0.1;
constexpr double kRightWheel = (kLinear + kAngular * 0.2) / 0.1;

std::string textOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no '" + from + "' in the world");
  return text.replace(at, from.size(), to);
}

constexpr const char* kPhysics = "ignition-gazebo-physics-system\" name=\"ignition::gazebo::systems::Physics";
// accepted, and does nothing
constexpr const char* kNothing =
    "ignition-gazebo-user-commands-system\" name=\"ignition::gazebo::systems::UserCommands";

/// A system's example world without moving models, so that a step consists of the systems alone.
struct SystemCase {
  std::string name;
  std::string text;
};

std::vector<SystemCase> systemCases() {
  std::vector<SystemCase> cases;
  for (const auto& file : fs::recursive_directory_iterator(test::projectFolder() / "plugins")) {
    if (file.path().extension() != ".sdf") continue;
    const std::string name = file.path().parent_path().filename().string();
    cases.push_back({name, replaced(textOf(file.path()), kPhysics, kNothing)});
  }
  if (cases.empty()) throw std::runtime_error("no example worlds of systems");
  std::ranges::sort(cases, {}, &SystemCase::name);
  return cases;
}

std::unique_ptr<Simulation> load(const std::string& text, bool loadSystems = true, bool useLevels = false) {
  Diagnostics diagnostics;
  SimulationOptions options;
  options.loadSystems = loadSystems;
  options.levels = useLevels;
  auto simulation = Simulation::fromText(text, "world.sdf", options, diagnostics);
  if (!simulation) throw std::runtime_error(format(diagnostics.all().front()));
  return simulation;
}

void stepWorld(::benchmark::State& run, const std::string& text) {
  const auto simulation = load(text);
  simulation->step(100);
  for (auto _ : run) simulation->step();
}

/// The example of DiffDrive with further robots, 2 m apart.
/// @param isInLevels Each ten robots are in a level, with a performer in the first level.
std::string manyRobots(int count = kRobots, bool isInLevels = false) {
  const std::string text = textOf(test::projectFolder() / "plugins/drives/diff-drive/diff_drive.sdf");
  const std::size_t begin = text.find("<model name=\"rover\">");
  const std::string closing = "</model>";
  const std::size_t end = text.find(closing, begin) + closing.size();
  const std::string robot = text.substr(begin, end - begin);
  std::string robots;
  std::string levels = isInLevels ? "<model name=\"scout\"><static>true</static><link name=\"link\"/></model><plugin "
                                    "filename=\"dummy\" name=\"gz::sim\"><performer name=\"p\"><ref>scout</ref>"
                                    "<geometry><box/></geometry></performer>"
                                  : "";
  for (int i = 0; i < count; ++i) {
    const std::string place = std::to_string(2 * (i % 10)) + " " + std::to_string(2 * (i / 10)) + " 0 0 0 0";
    robots += replaced(robot, "<model name=\"rover\">",
                       "<model name=\"rover" + std::to_string(i) + "\"><pose>" + place + "</pose>");
    if (!isInLevels) continue;
    if (i % kRobotsALevel == 0) {
      const std::string row = std::to_string(i / kRobotsALevel);
      levels += (i == 0 ? "" : "</level>") + ("<level name=\"" + row) + "\"><pose>9 " +
                std::to_string(2 * (i / kRobotsALevel)) +
                " 0 0 0 0</pose><geometry><box><size>20 0.9 2</size></box></geometry>";
    }
    levels += "<ref>rover" + std::to_string(i) + "</ref>";
  }
  if (isInLevels) levels += "</level></plugin>";
  return std::string(text).replace(begin, end - begin, robots + levels);
}

Pose poseOf(Simulation& simulation) { return simulation.world().model("rover0")->pose(); }

/// Fails if the robots do not drive, because then they cost less.
void requireDriven(Simulation& simulation, const Pose& start) {
  const double way = (poseOf(simulation).position - start.position).norm();
  if (way < kLeastWay) throw std::runtime_error("the robots do not drive");
}

/// Fifty robots that drive, as DiffDrive drives them.
std::unique_ptr<Simulation> drivenBySystem() {
  auto simulation = load(manyRobots());
  const MessagePointer twist = newMessage("ignition.msgs.Twist");
  parseMessage("linear: {x: " + std::to_string(kLinear) + "}, angular: {z: " + std::to_string(kAngular) + "}", *twist);
  std::vector<Publisher> publishers;
  for (int i = 0; i < kRobots; ++i) {
    publishers.push_back(simulation->transport().node().advertise("/model/rover" + std::to_string(i) + "/cmd_vel",
                                                                  "ignition.msgs.Twist"));
    publishers.back().publish(*twist);
  }
  const Pose start = poseOf(*simulation);
  simulation->step(kSettlingSteps);
  requireDriven(*simulation, start);
  return simulation;
}

/// The same robots without systems: their wheels are commanded once, as slowly as by DiffDrive.
std::unique_ptr<Simulation> drivenByHand() {
  auto simulation = load(manyRobots(), false);
  const Pose start = poseOf(*simulation);
  for (int step = 1; step <= kRampSteps; ++step) {
    const double share = static_cast<double>(step) / kRampSteps;
    for (const Model& model : simulation->world().models()) {
      if (auto joint = model.joint("left_wheel_joint")) joint->setVelocityTarget(kLeftWheel * share);
      if (auto joint = model.joint("right_wheel_joint")) joint->setVelocityTarget(kRightWheel * share);
    }
    simulation->step();
  }
  simulation->step(kSettlingSteps - kRampSteps);
  requireDriven(*simulation, start);
  return simulation;
}

/// A hundred bodies of all shapes, far from each other: on a floor, or free, without gravity, so that they stay.
/// @param fluid The parameters of Buoyancy, or empty: without it.
std::string manyBodies(const std::string& fluid, bool isOnFloor) {
  std::string text =
      "<sdf version='1.9'><world name='w'>"
      "<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>";
  if (!fluid.empty()) {
    text += "<plugin filename='ignition-gazebo-buoyancy-system' name='ignition::gazebo::systems::Buoyancy'>" + fluid +
            "</plugin>";
  }
  text += isOnFloor ? "<model name='floor'><static>1</static><pose>0 0 -0.5 0 0 0</pose><link name='link'><collision "
                      "name='collision'><geometry><plane/></geometry></collision></link></model>"
                    : "<gravity>0 0 0</gravity>";
  const char* const shapes[] = {"<box><size>1 1 1</size></box>", "<sphere><radius>0.5</radius></sphere>",
                                "<cylinder><radius>0.4</radius><length>1</length></cylinder>",
                                "<capsule><radius>0.3</radius><length>0.4</length></capsule>"};
  for (int i = 0; i < kBodies; ++i) {
    text += "<model name='body" + std::to_string(i) + "'><pose>" + std::to_string(3 * (i % 10)) + " " +
            std::to_string(3 * (i / 10)) + (isOnFloor ? " 0 0 0 0" : " 0 0.3 0.2 0") +
            "</pose><link name='link'><inertial><mass>1500</mass><inertia><ixx>200</ixx><iyy>200</iyy><izz>200</izz>"
            "</inertia></inertial><collision name='collision'><geometry>" +
            shapes[i % 4] + "</geometry></collision></link></model>";
  }
  return text + "</world></sdf>";
}

constexpr const char* kWater = "<uniform_fluid_density>1000</uniform_fluid_density>";
constexpr const char* kSurface =
    "<graded_buoyancy><density_change><above_depth>0</above_depth><density>1</density></density_change>"
    "</graded_buoyancy>";

struct Floater {
  double mass;
  /// Principal moments of inertia, and height of the centre of mass, which ballast lowers.
  const char* inertia;
  const char* center;
  const char* shape;
};

/// Boats, balls, drums and spar buoys that bob and roll forever without damping.
/// @param isInSea If false, the same bodies rotate as fast without gravity and Buoyancy.
std::unique_ptr<Simulation> bobbing(bool isInSea) {
  const Floater floaters[] = {
      {400, "<ixx>42</ixx><iyy>142</iyy><izz>167</izz>", "0 0 0", "<box><size>2 1 0.5</size></box>"},
      {250, "<ixx>25</ixx><iyy>25</iyy><izz>25</izz>", "0 0 0", "<sphere><radius>0.5</radius></sphere>"},
      {200, "<ixx>18</ixx><iyy>18</iyy><izz>25</izz>", "0 0 -0.1",
       "<cylinder><radius>0.5</radius><length>0.6</length></cylinder>"},
      {250, "<ixx>60</ixx><iyy>60</iyy><izz>10</izz>", "0 0 -0.4",
       "<capsule><radius>0.3</radius><length>1.2</length></capsule>"}};
  std::string text =
      "<sdf version='1.9'><world name='w'>"
      "<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>";
  text += isInSea ? "<plugin filename='ignition-gazebo-buoyancy-system' name='ignition::gazebo::systems::Buoyancy'>" +
                        std::string(kSurface) + "</plugin>"
                  : "<gravity>0 0 0</gravity>";
  for (int i = 0; i < kBodies; ++i) {
    const auto& [mass, inertia, center, shape] = floaters[i % 4];
    text += "<model name='body" + std::to_string(i) + "'><pose>" + std::to_string(4 * (i % 10)) + " " +
            std::to_string(4 * (i / 10)) + " 0.05 0.15 0.1 0</pose><link name='link'><inertial><pose>" + center +
            " 0 0 0</pose><mass>" + std::to_string(mass) + "</mass><inertia>" + inertia +
            "</inertia></inertial><collision name='collision'><geometry>" + shape +
            "</geometry></collision></link></model>";
  }
  auto simulation = load(text + "</world></sdf>");
  if (!isInSea) {
    for (Model model : simulation->world().models()) model.setVelocity({0, 0, 0.01}, {0.2, 0.1, 0});
  }
  simulation->step(kSettlingSteps);
  for (const Model& model : simulation->world().models()) {
    if (std::abs(model.pose().position.z()) > 0.5) throw std::runtime_error("what should float does not");
  }
  return simulation;
}

/// @param without, with Names of two benchmarks.
void printShare(const Medians& medians, const char* without, const char* with) {
  const double before = medians.of(without), after = medians.of(with);
  if (!(before > 0) || !(after > 0)) return;
  std::printf("%s: physics %.1f us, with Buoyancy %.1f us: %.1f %% more%s\n", with, before, after,
              100 * (after / before - 1), after / before - 1 > kMostShare ? "  TOO MUCH" : "");
}

/// Robots at rest.
std::unique_ptr<Simulation> standing(int count, bool isInLevels) {
  auto simulation = load(manyRobots(count, isInLevels), true, isInLevels);
  simulation->step(kSettlingSteps);
  const std::size_t there = simulation->world().models().size() + simulation->countSetAside();
  if (there != static_cast<std::size_t>(count) + (isInLevels ? 2U : 1U)) throw std::runtime_error("robots are missing");
  if (isInLevels != (simulation->countSetAside() > 0)) throw std::runtime_error("levels are not what they should be");
  return simulation;
}

void printLevels(const Medians& medians) {
  const double few = medians.of("levels/10_robots"), some = medians.of("levels/10_of_500_robots");
  if (!(few > 0) || !(some > 0)) return;
  std::printf(
      "\n%d robots %.1f us; %d, of which %d are in a level that is loaded, %.1f us: %.1f %% more%s; all %d %.0f us\n",
      kRobotsALevel, few, kRobotsInLevels, kRobotsALevel, some, 100 * (some / few - 1),
      some / few - 1 > kMostForLevels ? "  TOO MUCH" : "", kRobotsInLevels, medians.of("levels/500_robots"));
}

void printTable(const Medians& medians, const std::vector<SystemCase>& cases) {
  const double nothing = medians.of("nothing");
  if (nothing > 0) {
    std::printf(
        "\nA step of each system's example world in which nothing moves and nobody listens, less one without "
        "systems (%.3f us):\n",
        nothing);
  }
  for (const SystemCase& each : cases) {
    const double cost = medians.of(each.name) - nothing;
    if (!(medians.of(each.name) > 0) || !(nothing > 0)) continue;
    std::printf("%-30s %7.3f us%s\n", each.name.c_str(), cost, cost > kMostMicroseconds ? "  TOO MUCH" : "");
  }
  const double byHand = medians.of("50_robots/physics"), bySystem = medians.of("50_robots/diff_drive");
  if (!(byHand > 0) || !(bySystem > 0)) return;
  const double share = bySystem / byHand - 1;
  std::printf("\n%d robots: physics %.1f us, with DiffDrive %.1f us: %.1f %% more%s\n", kRobots, byHand, bySystem,
              100 * share, share > kMostShare ? "  TOO MUCH" : "");
}

int run(int argc, char** argv) {
  const std::vector<SystemCase> cases = systemCases();
  // for systems that write into the current folder
  const test::WorkingFolder folder;
  const auto add = [](const std::string& name, auto function, const std::string& text) {
    ::benchmark::RegisterBenchmark(name.c_str(), function, text)->Unit(::benchmark::kMicrosecond);
  };
  add("nothing", stepWorld,
      std::string("<sdf version='1.9'><world name='w'><plugin filename=\"") + kNothing + "\"/></world></sdf>");
  for (const SystemCase& each : cases) add(each.name, stepWorld, each.text);
  // one simulation for all repetitions, because robots need a while to reach their speed
  std::map<std::string, std::unique_ptr<Simulation>> driven;
  const auto addDriven = [&driven](const char* name, auto make) {
    const auto step = [&driven, name, make](::benchmark::State& state) {
      std::unique_ptr<Simulation>& simulation = driven[name];
      if (!simulation) simulation = make();
      for (auto _ : state) simulation->step();
    };
    ::benchmark::RegisterBenchmark(name, step)->Unit(::benchmark::kMicrosecond);
  };
  add("100_bodies/free", stepWorld, manyBodies("", false));
  add("100_bodies/free_under_water", stepWorld, manyBodies(kWater, false));
  add("100_bodies/free_at_the_surface", stepWorld, manyBodies(kSurface, false));
  add("100_bodies/on_a_floor", stepWorld, manyBodies("", true));
  add("100_bodies/on_a_floor_under_water", stepWorld, manyBodies(kWater, true));
  add("100_bodies/on_a_floor_at_the_surface", stepWorld, manyBodies(kSurface, true));
  addDriven("100_bodies/turning", [] { return bobbing(false); });
  addDriven("100_bodies/bobbing_at_the_surface", [] { return bobbing(true); });
  addDriven("50_robots/physics", drivenByHand);
  addDriven("50_robots/diff_drive", drivenBySystem);
  addDriven("levels/10_robots", [] { return standing(kRobotsALevel, false); });
  addDriven("levels/10_of_500_robots", [] { return standing(kRobotsInLevels, true); });
  addDriven("levels/500_robots", [] { return standing(kRobotsInLevels, false); });
  Medians medians;
  if (!medians.run(argc, argv)) return 2;
  printTable(medians, cases);
  printShare(medians, "100_bodies/free", "100_bodies/free_under_water");
  printShare(medians, "100_bodies/free", "100_bodies/free_at_the_surface");
  printShare(medians, "100_bodies/turning", "100_bodies/bobbing_at_the_surface");
  printShare(medians, "100_bodies/on_a_floor", "100_bodies/on_a_floor_under_water");
  printShare(medians, "100_bodies/on_a_floor", "100_bodies/on_a_floor_at_the_surface");
  printLevels(medians);
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) { return pongsim::benchmark::run(argc, argv); }
