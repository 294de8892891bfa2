#include <CLI/App.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/crash_report.hh"
#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/diagnostic_report.hh"
#include "cli/extension.hh"
#include "cli/extension_world.hh"
#include "cli/network_option.hh"
#include "cli/number_option.hh"
#include "cli/offline_option.hh"
#include "cli/readiness.hh"
#include "cli/stop_signal.hh"
#include "cli/world_file.hh"
#include "pongsim/log.hh"
#include "pongsim/simulation.hh"
#include "sim/runner.hh"

namespace pongsim::cli {

namespace {

struct RunCommandOptions {
  std::string world;
  sim::RunOptions run;
  bool runAtOnce = false;
  std::uint64_t seed = 0;
  int threads = 1;
  LogLevel verbosity = LogLevel::kWarning;
  bool hash = false;
  bool strict = false;
  bool levels = false;
  /// Of extensions.
  RunAdditions additions;
};

/// @return `value` as people write it: "1", "0.5".
std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string startLine(Simulation& simulation, const sim::RunOptions& options) {
  World world = simulation.world();
  const std::size_t models = world.models().size();
  const std::size_t away = simulation.countSetAside();
  const std::string setAside = away == 0 ? "" : " and " + std::to_string(away) + " in levels not loaded";
  std::string text = "world '" + std::string(world.name()) + "': " + std::to_string(models) +
                     (models == 1 ? " model" : " models") + setAside + ", step " +
                     shortNumber(toSeconds(simulation.stepSize()) * 1e3) + " ms, ";
  if (options.updateRate) {
    text += *options.updateRate > 0 ? shortNumber(*options.updateRate) + " steps a second" : "as fast as possible";
  } else if (simulation.realTimeFactor() > 0) {
    text += "real-time factor " + shortNumber(simulation.realTimeFactor());
  } else {
    text += "as fast as possible";
  }
  return text + (options.paused ? ", paused" : "");
}

/// @return Null where there was an error, which is in `diagnostics` or has been said.
std::unique_ptr<Simulation> load(const RunCommandOptions& options, Transport& transport, Diagnostics& diagnostics) {
  const RunAdditions& additions = options.additions;
  const SimulationOptions how{.seed = options.seed,
                              .physics = !additions.world,
                              .strict = options.strict,
                              .threads = options.threads,
                              .levels = options.levels,
                              .transport = &transport,
                              .systems = additions.systems};
  if (additions.world) {
    const std::optional<std::string> text = printedWorld(*additions.world);
    return text ? Simulation::fromText(*text, additions.world->arguments.back(), how, diagnostics) : nullptr;
  }
  const std::optional<std::filesystem::path> file = fetchWorldFile(options.world, diagnostics);
  return file ? Simulation::fromFile(*file, how, diagnostics) : nullptr;
}

int runWorld(const RunCommandOptions& options) {
  setLogLevel(options.verbosity);
  base::reportCrashes();
  StopSignal signal;
  Transport transport;
  Diagnostics diagnostics;
  const std::unique_ptr<Simulation> simulation = load(options, transport, diagnostics);
  if (options.strict) diagnostics = asErrors(diagnostics);
  say(diagnostics, options.verbosity >= LogLevel::kWarning ? Severity::kWarning : Severity::kError, Severity::kError);
  if (simulation == nullptr || diagnostics.hasErrors()) {
    const auto errors = std::ranges::count(diagnostics.all(), Severity::kError, &Diagnostic::severity);
    if (errors == 0) return kFailed;
    say(std::to_string(errors) + (errors == 1 ? " error" : " errors"));
    return kFailed;
  }

  if (options.verbosity != LogLevel::kNone) {
    say(startLine(*simulation, options.run));
    if (const auto open = transport.openTo()) say("open to the network of " + *open + ": anybody there can command it");
  }
  sim::Runner runner(*simulation, options.run);
  signal.onStop([&runner] { runner.stop(); });
  tellReady(startLine(*simulation, options.run));
  runner.run();
  tellStopping();
  signal.onStop({});

  if (!options.hash) return kDone;
  char line[48];
  std::snprintf(line, sizeof line, "state hash: %016llx\n", static_cast<unsigned long long>(simulation->stateHash()));
  return print(line) ? kDone : kFailed;
}

void checkAndSchedule(const RunCommandOptions& options, Work& work) {
  const std::string& worldOption = options.additions.worldOption;
  if (options.world.empty() && worldOption.empty()) throw UsageError("no world file given", "pongsim run WORLD");
  if (!options.world.empty() && !worldOption.empty()) {
    throw UsageError("a world file and option '" + worldOption + "' exclude each other",
                     "the option has the world: leave out '" + options.world + "'");
  }
  if (options.runAtOnce && options.run.paused) throw UsageError("options '-r' and '--paused' exclude each other");
  work = [&options] { return runWorld(options); };
}

void addRunCommand(CLI::App& program, Work& work, std::span<const Extension> extensions) {
  const auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = program.add_subcommand("run", "Simulate a world until SIGINT or SIGTERM");
  command->set_help_flag("-h,--help", "Print this and end");
  command
      ->add_option("WORLD", options->world,
                   "World file, or one with a model: a path, or a name in the folders of\n"
                   "PONGSIM_RESOURCE_PATH, SDF_PATH, IGN_GAZEBO_RESOURCE_PATH, GZ_SIM_RESOURCE_PATH\n"
                   "or in pongsim's own; or the address of one on a Fuel server")
      ->type_name("");
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  addFlag("-r", options->runAtOnce, "Run from the start, as happens anyway without --paused");
  addFlag("--paused", options->run.paused, "Begin paused");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  add("--iterations", "N", "End after N steps; 0: never", [options](const std::string& text) {
    const std::uint64_t count = wholeNumber("--iterations", text);
    options->run.iterations = count == 0 ? std::nullopt : std::optional(count);
  });
  add("-z", "HZ", "Steps a second of wall time, not what the world says; 0: as many as possible",
      [options](const std::string& text) {
        options->run.updateRate = numberFromZero("-z", text, "a number of steps a second");
      });
  add("--seed", "N", "Where all random numbers come from, 0 to 2^64-1 (0)",
      [options](const std::string& text) { options->seed = wholeNumber("--seed", text); });
  add("--threads", "N", "Move bodies on N threads, 1 to 256 (1); the result is the same",
      [options](const std::string& text) {
        options->threads = static_cast<int>(wholeNumber("--threads", text, 1, 256));
      });
  add("-v,--verbose", "LEVEL", "How much is said: 0 nothing, 1 errors, 2 warnings, 3 information, 4 all (2)",
      [options](const std::string& text) {
        options->verbosity = static_cast<LogLevel>(wholeNumber("-v", text, 0, 4));
      });
  addFlag("--strict", options->strict,
          "Take warnings about the file for errors, and end with exit code 1 where a system fails");
  addFlag("--levels", options->levels,
          "Load what is in a <level> only while a <performer> is near; without it all is loaded");
  addFlag("--hash", options->hash, "At the end print a number made of all bits of the state");
  addNetworkOption(*command);
  addOfflineOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim run worlds/pong_world.sdf\n"
      "  pongsim run worlds/pong_world.sdf --paused -v 3\n"
      "  pongsim run worlds/pong_world.sdf -z 0 --iterations 10000 --hash");
  for (const Extension& extension : extensions) addRunOptions(*command, extension, options->additions);
  command->callback([options, &work] { checkAndSchedule(*options, work); });
}

}  // namespace

void addRunCommand(CLI::App& program, Work& work) { addRunCommand(program, work, installedExtensions()); }

void addPlainRunCommand(CLI::App& program, Work& work) { addRunCommand(program, work, {}); }

}  // namespace pongsim::cli
