// Measures reading worlds, compared with libsdformat 12, if it is installed, in the same run.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/medians.hh"
#include "benchmark/shapes_world.hh"
#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"

#ifdef PONGSIM_HAS_SDFORMAT
#include <sdf/sdf.hh>
#endif

namespace pongsim::benchmark {
namespace {

struct Case {
  std::string name;
  std::string text;
  /// libsdformat takes minutes for thousands of models.
  bool isForBoth = true;
};

std::vector<Case> cases() {
  std::vector<Case> result;
  if (const auto worlds = test::fortressWorlds()) {
    std::ifstream stream(*worlds / "tutorials" / "moving_robot.sdf");
    result.push_back({"moving_robot", {std::istreambuf_iterator<char>(stream), {}}});
  }
  result.push_back({"300_models", shapesWorld(300)});
  result.push_back({"3000_models", shapesWorld(3000), false});
  return result;
}

void load(::benchmark::State& run, const Case& which) {
  for (auto _ : run) {
    Diagnostics diagnostics;
    const sdf::Root root = sdf::loadText(which.text, which.name, diagnostics);
    if (diagnostics.hasErrors()) throw std::runtime_error(format(diagnostics.all().front()));
    ::benchmark::DoNotOptimize(root.worlds.data());
  }
}

#ifdef PONGSIM_HAS_SDFORMAT
void loadTheirs(::benchmark::State& run, const Case& which) {
  for (auto _ : run) {
    ::sdf::Root root;
    if (!root.LoadSdfString(which.text).empty()) throw std::runtime_error("libsdformat does not load " + which.name);
    ::benchmark::DoNotOptimize(root.WorldCount());
  }
}
#endif

/// @return Peak memory of the process so far [MB].
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1000;
}

void printTable(const Medians& medians, const std::vector<Case>& all) {
  std::printf("\n%-14s %10s %14s %18s %8s\n", "world", "size [kB]", "pongsim [ms]", "libsdformat [ms]", "ratio");
  for (const Case& which : all) {
    const double own = medians.of(which.name + "/pongsim"), theirs = medians.of(which.name + "/libsdformat");
    std::printf("%-14s %10.0f %14.3f", which.name.c_str(), static_cast<double>(which.text.size()) / 1e3, own);
    if (theirs > 0) std::printf(" %18.1f %8.0f", theirs, theirs / own);
    std::printf("\n");
  }
}

int run(int argc, char** argv) {
  const std::vector<Case> all = cases();
  const double before = peakMemory();
  Diagnostics diagnostics;
  sdf::loadText(all.back().text, all.back().name, diagnostics);
  const double memory = peakMemory() - before;
  for (const Case& which : all) {
    ::benchmark::RegisterBenchmark((which.name + "/pongsim").c_str(), load, which)->Unit(::benchmark::kMillisecond);
#ifdef PONGSIM_HAS_SDFORMAT
    if (!which.isForBoth) continue;
    ::benchmark::RegisterBenchmark((which.name + "/libsdformat").c_str(), loadTheirs, which)
        ->Unit(::benchmark::kMillisecond);
#endif
  }
  Medians medians;
  if (!medians.run(argc, argv)) return 2;
  printTable(medians, all);
  std::printf("memory for %s: %.0f MB\n", all.back().name.c_str(), memory);
  return 0;
}

}  // namespace
}  // namespace pongsim::benchmark

int main(int argc, char** argv) { return pongsim::benchmark::run(argc, argv); }
