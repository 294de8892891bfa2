#include "cli/replay/recorded_world.hh"

#include <cstdio>
#include <utility>

#include "cli/files/diagnostic_report.hh"
#include "cli/options/number_option.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

SimulationOptions optionsOf(const sim::RunStart& start, const WorldLoading& loading) {
  SimulationOptions options;
  options.seed = start.seed;
  options.threads = loading.threads;
  options.levels = start.levels;
  options.transport = loading.transport;
  options.systems = start.systems;
  options.world = start.onlyWorld;
  options.allowPluginPaths = start.allowPluginPaths;
  options.outsideSystems = loading.transport != nullptr;
  return options;
}

Worlds listOf(std::unique_ptr<Simulation> simulation) {
  Worlds worlds;
  if (simulation) worlds.push_back(std::move(simulation));
  return worlds;
}

}  // namespace

Worlds loadFile(const std::filesystem::path& file, const sim::RunStart& start, const WorldLoading& loading,
                Diagnostics& diagnostics) {
  const SimulationOptions options = optionsOf(start, loading);
  if (start.onlyWorld.empty()) return Simulation::allFromFile(file, options, diagnostics);
  return listOf(Simulation::fromFile(file, options, diagnostics));
}

Worlds loadRecorded(const sim::RunStart& start, const WorldLoading& loading, Diagnostics& diagnostics) {
  SimulationOptions options = optionsOf(start, loading);
  Worlds worlds;
  for (const std::string& name : start.worlds) {
    if (start.worlds.size() > 1) options.world = name;
    std::unique_ptr<Simulation> world = Simulation::fromText(start.sdf, start.file, options, diagnostics);
    if (!world) return {};
    worlds.push_back(std::move(world));
  }
  return worlds;
}

void checkLoaded(const Worlds& worlds, const Diagnostics& diagnostics, bool warns) {
  say(diagnostics, warns ? Severity::kWarning : Severity::kError, Severity::kError);
  if (worlds.empty() || diagnostics.hasErrors()) throw Failure("the world can't be loaded");
}

sim::WorldContent contentOf(const sim::RunStart& start) { return {start.sdf, start.files}; }

std::string placeOf(std::uint64_t steps, const Simulation& simulation) {
  return "step " + std::to_string(steps) + " (" + shortNumber(toSeconds(simulation.time())) + " s)";
}

std::string hashText(std::uint64_t hash) {
  char number[20];
  std::snprintf(number, sizeof number, "%016llx", static_cast<unsigned long long>(hash));
  return std::string("state hash ") + number;
}

}  // namespace pongsim::cli
