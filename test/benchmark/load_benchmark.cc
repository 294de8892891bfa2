// What it takes to read a world, beside libsdformat 12 where that is installed, in the same run.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/medians.hh"
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

/// @return A world of boxes, spheres and cylinders in rows, each with what a model of Fortress's shapes.sdf has.
std::string shapes(int count) {
  const char* const geometries[] = {"<box><size>1 1 1</size></box>", "<sphere><radius>0.5</radius></sphere>",
                                    "<cylinder><radius>0.5</radius><length>1</length></cylinder>"};
  std::string text = "<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">\n  <world name=\"shapes\">\n";
  for (int i = 0; i < count; ++i) {
    const std::string geometry = std::string("<geometry>") + geometries[i % 3] + "</geometry>";
    text += "    <model name=\"shape_" + std::to_string(i) + "\">\n      <pose>" + std::to_string(i % 50 * 2) + " " +
            std::to_string(i / 50 * 2) + " 0.5 0 0 0</pose>\n      <link name=\"link\">\n        <inertial>\n" +
            "          <inertia>\n            <ixx>0.16666</ixx>\n            <ixy>0</ixy>\n" +
            "            <ixz>0</ixz>\n            <iyy>0.16666</iyy>\n            <iyz>0</iyz>\n" +
            "            <izz>0.16666</izz>\n          </inertia>\n          <mass>1.0</mass>\n" +
            "        </inertial>\n        <collision name=\"collision\">" + geometry +
            "</collision>\n        <visual name=\"visual\">" + geometry +
            "\n          <material>\n            <ambient>1 0 0 1</ambient>\n            <diffuse>1 0 0 1</diffuse>\n" +
            "            <specular>1 0 0 1</specular>\n          </material>\n        </visual>\n      </link>\n" +
            "    </model>\n";
  }
  return text + "  </world>\n</sdf>\n";
}

std::vector<Case> cases() {
  std::vector<Case> result;
  if (const auto worlds = test::fortressWorlds()) {
    std::ifstream stream(*worlds / "tutorials" / "moving_robot.sdf");
    result.push_back({"moving_robot", {std::istreambuf_iterator<char>(stream), {}}});
  }
  result.push_back({"300_models", shapes(300)});
  result.push_back({"3000_models", shapes(3000), false});
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

/// @return The most memory that the process has had so far [MB].
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
