// Measures the cost per model of reading, inserting, removing and publishing models, and per robot of loading robots
// with topics, for different numbers. A cost that grows from left to right is worse than linear.

#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/shapes_world.hh"
#include "pongsim/scene.hh"
#include "pongsim/simulation.hh"

namespace pongsim::benchmark {
namespace {

constexpr std::array kCounts{300, 1000, 3000, 10000};
/// Number of runs, of which the fastest counts.
constexpr int kRuns = 3;

/// @return Processor time of the process [us].
double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

double timeOf(const std::function<void()>& work) {
  const double before = processorTime();
  work();
  return processorTime() - before;
}

void expect(const Diagnostics& diagnostics) {
  if (diagnostics.hasErrors()) throw std::runtime_error(format(diagnostics.all().front()));
}

void expect(const Outcome<void>& outcome) {
  if (!outcome) throw std::runtime_error(outcome.error);
}

/// Rows of the table in their order, each with the time of one run [us].
using Times = std::vector<std::pair<std::string, double>>;

std::unique_ptr<Simulation> simulationOf(const std::string& world) {
  Diagnostics diagnostics;
  std::unique_ptr<Simulation> simulation = Simulation::fromText(world, "shapes.sdf", {}, diagnostics);
  expect(diagnostics);
  return simulation;
}

/// Costs of a world with all of the models.
void measureWhole(const std::string& world, Times& times) {
  times.emplace_back("parsing the XML, by tinyxml2", timeOf([&world] {
                       tinyxml2::XMLDocument document;
                       document.Parse(world.data(), world.size());
                     }));
  std::unique_ptr<Simulation> simulation;
  times.emplace_back("loading", timeOf([&] { simulation = simulationOf(world); }));
  times.emplace_back("first step", timeOf([&] { simulation->step(); }));
  constexpr int kSteps = 10;
  times.emplace_back("a later step", timeOf([&] { simulation->step(kSteps); }) / kSteps);
  const World handle = simulation->world();
  times.emplace_back("scene", timeOf([&] {
                       ignition::msgs::Scene message;
                       Scene(handle).fillIn(message);
                     }));
  times.emplace_back("state", timeOf([&] {
                       ignition::msgs::SerializedStepMap message;
                       Scene(handle).fillInState(message, StateContent::kAll, false);
                     }));
  std::vector<std::byte> state;
  times.emplace_back("saving the state", timeOf([&] { state = simulation->saveState(); }));
  times.emplace_back("restoring it", timeOf([&] { expect(simulation->restoreState(state)); }));
  Diagnostics diagnostics;
  times.emplace_back("reset", timeOf([&] { simulation->reset(diagnostics); }));
  times.emplace_back("ending", timeOf([&] { simulation.reset(); }));
}

/// Costs of filling a world and emptying it, one model at a time and all at once.
void measureEdits(int count, Times& times) {
  const std::unique_ptr<Simulation> simulation = simulationOf(shapesWorld(0));
  std::vector<std::string> texts;
  for (int i = 0; i < count; ++i) texts.push_back("<sdf version=\"1.6\">" + shapeModel(i) + "</sdf>");
  Diagnostics diagnostics;
  std::vector<Model> models;
  const auto insertAll = [&] {
    for (const std::string& text : texts) {
      models.push_back(simulation->insertText(text, "shape.sdf", {}, diagnostics).value());
    }
  };
  times.emplace_back("inserting one by one", timeOf(insertAll));
  times.emplace_back("removing all at once", timeOf([&] { expect(simulation->remove(models)); }));
  models.clear();
  insertAll();
  simulation->step();
  times.emplace_back("removing the last each time", timeOf([&] {
                                                      for (int i = 0; i < count / 2; ++i) {
                                                        expect(simulation->remove(models.back()));
                                                        models.pop_back();
                                                      }
                                                    }) * 2);
  times.emplace_back("removing the first each time", timeOf([&] {
                                                       for (const Model& model : models)
                                                         expect(simulation->remove(model));
                                                     }) * 2);
}

Times measure(int count) {
  Times best;
  const std::string world = shapesWorld(count);
  for (int run = 0; run < kRuns; ++run) {
    Times times;
    measureWhole(world, times);
    measureEdits(count, times);
    if (best.empty()) best = times;
    for (std::size_t i = 0; i < best.size(); ++i) best[i].second = std::min(best[i].second, times[i].second);
  }
  return best;
}

/// @return Robots, each with a diff drive, an IMU and a joint state publisher: eight topics.
std::string robotsWorld(int count) {
  std::string world =
      "<sdf version=\"1.9\"><world name=\"robots\"><plugin filename=\"ignition-gazebo-physics-system\" "
      "name=\"ignition::gazebo::systems::Physics\"/><plugin filename=\"ignition-gazebo-imu-system\" "
      "name=\"ignition::gazebo::systems::Imu\"/>";
  const auto wheel = [](const std::string& name, const std::string& y) {
    return "<link name=\"" + name + "\"><pose>0 " + y + " 0 -1.5708 0 0</pose><collision name=\"shape\"><geometry>" +
           "<sphere><radius>0.1</radius></sphere></geometry></collision></link><joint name=\"" + name +
           "_joint\" type=\"revolute\"><parent>chassis</parent><child>" + name +
           "</child><axis><xyz>0 0 1</xyz></axis></joint>";
  };
  for (int i = 0; i < count; ++i) {
    world += "<model name=\"robot" + std::to_string(i) + "\"><pose>" + std::to_string(2 * i) +
             " 0 0.1 0 0 0</pose><link name=\"chassis\"><sensor name=\"imu\" type=\"imu\"/></link>" +
             wheel("left", "0.2") + wheel("right", "-0.2") +
             "<plugin filename=\"ignition-gazebo-diff-drive-system\" name=\"ignition::gazebo::systems::DiffDrive\">"
             "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin>"
             "<plugin filename=\"ignition-gazebo-joint-state-publisher-system\" "
             "name=\"ignition::gazebo::systems::JointStatePublisher\"/></model>";
  }
  return world + "</world></sdf>";
}

/// Prints the cost of loading and ending robots whose topics other processes can discover.
void printRobots() {
  constexpr std::array kRobots{30, 100, 300, 1000, 3000};
  std::array<double, kRobots.size()> loading{}, ending{};
  for (std::size_t i = 0; i < kRobots.size(); ++i) {
    const std::string world = robotsWorld(kRobots[i]);
    for (int run = 0; run < kRuns; ++run) {
      std::optional<Transport> transport(std::in_place);
      Diagnostics diagnostics;
      std::unique_ptr<Simulation> simulation;
      SimulationOptions options;
      options.transport = &*transport;
      const double loaded = timeOf([&] {
        simulation = Simulation::fromText(world, "robots.sdf", options, diagnostics);
        expect(diagnostics);
      });
      const double ended = timeOf([&] {
        simulation.reset();
        transport.reset();
      });
      loading[i] = run == 0 ? loaded : std::min(loading[i], loaded);
      ending[i] = run == 0 ? ended : std::min(ending[i], ended);
    }
  }
  std::printf("\n%-32s", "a robot with topics [us]");
  for (const int count : kRobots) std::printf(" %9d", count);
  for (const auto& [name, times] : {std::pair("loading", loading), std::pair("ending", ending)}) {
    std::printf("\n%-32s", name);
    for (std::size_t i = 0; i < kRobots.size(); ++i) std::printf(" %9.0f", times[i] / kRobots[i]);
  }
  std::printf("\n");
}

int run() {
  std::vector<Times> columns;
  for (const int count : kCounts) columns.push_back(measure(count));
  std::printf("%-32s", "a model, as often as its XML");
  for (const int count : kCounts) std::printf(" %9d", count);
  std::printf("\n");
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    std::printf("%-32s", columns.front()[row].first.c_str());
    for (std::size_t i = 0; i < kCounts.size(); ++i) {
      const double time = columns[i][row].second;
      if (row == 0) {
        std::printf(" %6.2f us", time / kCounts[i]);
      } else {
        std::printf(" %9.2f", time / columns[i].front().second);
      }
    }
    std::printf("\n");
  }
  printRobots();
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main() { return pongsim::benchmark::run(); }
