// Measures the cost of reading, inserting, removing and publishing models, for few and for many: a row that grows from
// left to right is worse than linear.

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
/// The best of this many runs counts.
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

void expect(const std::optional<std::string>& refusal) {
  if (refusal) throw std::runtime_error(*refusal);
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
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main() { return pongsim::benchmark::run(); }
