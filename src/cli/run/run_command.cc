#include <CLI/App.hpp>
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/report/crash_report.hh"
#include "cli/command.hh"
#include "cli/extension/extension.hh"
#include "cli/extension/extension_world.hh"
#include "cli/files/diagnostic_report.hh"
#include "cli/files/world_file.hh"
#include "cli/help/version.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/offline_option.hh"
#include "cli/options/renderer_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/options/xacro_options.hh"
#include "cli/replay/recorded_world.hh"
#include "cli/run/fault_argument.hh"
#include "cli/run/fortress_environment.hh"
#include "cli/run/fortress_run_options.hh"
#include "cli/run/input_recording.hh"
#include "cli/run/lockstep_arguments.hh"
#include "cli/run/readiness.hh"
#include "cli/stop_signal.hh"
#include "pongsim/log.hh"
#include "pongsim/program/keystore.hh"
#include "pongsim/simulation.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "sim/inputs/world_content.hh"
#include "sim/running/runner.hh"
#include "sim/running/server.hh"

namespace pongsim::cli {

namespace {

struct RunCommandOptions {
  /// Empty: none.
  std::string file;
  bool hasFile = false;
  /// Name of a world in the file; empty: all.
  std::string world;
  sim::RunOptions run;
  bool runAtOnce = false;
  std::uint64_t seed = 0;
  int threads = 1;
  LogLevel verbosity = LogLevel::kWarning;
  bool hash = false;
  std::optional<std::uint64_t> hashPeriod;
  bool strict = false;
  bool allowPluginPaths = false;
  bool levels = false;
  /// Empty: none.
  std::string recordedInputs;
  std::vector<std::string> xacroArguments;
  /// From extensions.
  RunAdditions additions;
  FortressRunOptions fortress;
  LockstepArguments lockstep;
};

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

/// @return The worlds to run; none on errors, which are in `diagnostics` or have been reported.
Worlds loadWorlds(const RunCommandOptions& options, Transport& transport, Diagnostics& diagnostics) {
  const RunAdditions& additions = options.additions;
  const SimulationOptions simulated{.seed = options.seed,
                                    .strict = options.strict,
                                    .threads = options.threads,
                                    .levels = options.levels,
                                    .transport = &transport,
                                    .systems = additions.systems,
                                    .world = options.world,
                                    .physics = !additions.world,
                                    .allowPluginPaths = options.allowPluginPaths};
  std::unique_ptr<Simulation> one;
  if (additions.world) {
    const std::optional<std::string> text = printedWorld(*additions.world);
    if (!text) return {};
    one = Simulation::fromText(*text, additions.world->arguments.back(), simulated, diagnostics);
  } else if (!options.hasFile) {
    // as in Fortress
    one = Simulation::fromText(kEmptyWorld, "the empty world", simulated, diagnostics);
  } else {
    const std::optional<std::filesystem::path> file = fetchWorldFile(options.file, diagnostics);
    if (!file) return {};
    if (options.world.empty()) return Simulation::allFromFile(*file, simulated, diagnostics);
    one = Simulation::fromFile(*file, simulated, diagnostics);
  }
  Worlds worlds;
  if (one) worlds.push_back(std::move(one));
  return worlds;
}

/// Prints which worlds run, and what they lack.
void announce(const Worlds& worlds, const RunCommandOptions& options, const Transport& transport) {
  if (options.verbosity == LogLevel::kNone) return;
  for (const auto& world : worlds) say(startLine(*world, options.run));
  const auto open = transport.openTo();
  if (open && isSecured()) say("open to the network of " + *open + ", for identities of its keystore");
  if (open && !isSecured()) {
    say("open to the network of " + *open + ": anybody there can command it, since topics are not secured\n" +
        "  hint: 'pongsim security init' makes a keystore for --secure");
  }
}

/// @param of Empty, or " of " and the world's name, if there are several.
/// @param when Empty, or " after " and the number of steps.
std::string hashLine(const Simulation& world, const std::string& of, const std::string& when) {
  char number[20];
  std::snprintf(number, sizeof number, "%016llx", static_cast<unsigned long long>(world.stateHash()));
  return "state hash" + of + when + ": " + number + "\n";
}

std::string nameWhereSeveral(Simulation& world, std::size_t worlds) {
  return worlds == 1 ? "" : " of " + std::string(world.world().name());
}

bool printHashes(const Worlds& worlds) {
  std::string text;
  for (const auto& world : worlds) text += hashLine(*world, nameWhereSeveral(*world, worlds.size()), "");
  return print(text);
}

/// @return A function that prints a world's hash after every `period` of its steps.
std::function<bool(Simulation&)> hashPrinter(std::uint64_t period, std::size_t worlds) {
  return [period, worlds](Simulation& world) {
    if (world.iterations() % period != 0) return true;
    return print(hashLine(world, nameWhereSeveral(world, worlds), " after " + std::to_string(world.iterations())));
  };
}

/// @return What a recording of the run's inputs begins with.
sim::RunStart startOf(const RunCommandOptions& options, const Worlds& worlds) {
  sim::RunStart start;
  start.version = versionText();
  start.sdf = kEmptyWorld;
  if (options.hasFile) {
    Diagnostics diagnostics;
    const std::filesystem::path file = fetchWorldFile(options.file, diagnostics).value_or(options.file);
    start.file = std::filesystem::absolute(file).lexically_normal().string();
    if (std::optional<sim::WorldContent> content = sim::contentOf(start.file)) {
      start.sdf = std::move(content->sdf);
      start.files = std::move(content->files);
    }
  }
  for (const auto& world : worlds) start.worlds.emplace_back(world->world().name());
  start.onlyWorld = options.world;
  start.systems = options.additions.systems;
  start.seed = options.seed;
  start.levels = options.levels;
  start.allowPluginPaths = options.allowPluginPaths;
  start.paused = options.run.paused;
  return start;
}

/// Lets the worlds' systems complete their files, such as recordings.
/// @return Whether all are complete; otherwise it was reported.
bool finish(const Worlds& worlds) {
  bool areComplete = true;
  for (const auto& world : worlds) {
    const Outcome<void> finished = world->finish();
    if (!finished) sayError(finished.error);
    areComplete = areComplete && finished;
  }
  return areComplete;
}

/// Adds what the options say of lockstep to those of the run.
/// @return Whether it is possible; otherwise it was reported.
bool addLockstep(const Worlds& worlds, const RunCommandOptions& options, sim::RunOptions& run) {
  run.lockstep = options.lockstep.check();
  if (!run.lockstep) return true;
  if (worlds.size() > 1) {
    sayError("a run in lockstep is of a single world", "choose one: pongsim run FILE -w WORLD --lockstep TOPIC");
    return false;
  }
  return true;
}

/// Warns about topics of the lockstep that the world does not have.
void warnOfUnknownTopics(const Worlds& worlds, const RunCommandOptions& options, const sim::RunOptions& run) {
  if (!run.lockstep || options.verbosity < LogLevel::kWarning) return;
  for (const std::string& sentence : unknownLockstepTopics(*run.lockstep, worlds.front()->transport().node())) {
    say("warning: " + sentence);
  }
}

/// Warns about Fortress options and variables that have no effect.
void warnOfIgnored(const FortressRunOptions& options) {
  for (const std::string& sentence : options.check()) say("warning: " + sentence);
  for (const std::string& sentence : ignoredVariables()) say("warning: " + sentence);
}

int runWorlds(const RunCommandOptions& options) {
  setLogLevel(options.verbosity);
  if (options.verbosity >= LogLevel::kWarning) warnOfIgnored(options.fortress);
  base::reportCrashes();
  StopSignal signal;
  Transport transport({.announceLater = true});
  Diagnostics diagnostics;
  const Worlds worlds = loadWorlds(options, transport, diagnostics);
  if (options.strict) diagnostics = asErrors(diagnostics);
  say(diagnostics, options.verbosity >= LogLevel::kWarning ? Severity::kWarning : Severity::kError, Severity::kError);
  if (worlds.empty() || diagnostics.hasErrors()) {
    const auto errors = std::ranges::count(diagnostics.all(), Severity::kError, &Diagnostic::severity);
    if (errors == 0) return kFailed;
    say(std::to_string(errors) + (errors == 1 ? " error" : " errors"));
    return kFailed;
  }

  sim::RunOptions run = options.run;
  if (!addLockstep(worlds, options, run)) return kFailed;
  transport.announce();
  announce(worlds, options, transport);
  std::atomic<bool> isPrinted = true;
  if (options.hashPeriod) {
    run.stepped = [&isPrinted, printHash = hashPrinter(*options.hashPeriod, worlds.size())](Simulation& world) {
      if (!printHash(world)) isPrinted = false;
      return isPrinted.load();
    };
  }
  std::optional<InputRecording> inputs;
  if (!options.recordedInputs.empty()) {
    inputs.emplace(options.recordedInputs, startOf(options, worlds), worlds);
    inputs->addTo(run);
  }
  std::optional<sim::Server> server(std::in_place, transport, worlds, run);
  // which has the run's own, such as the clock
  warnOfUnknownTopics(worlds, options, run);
  {
    const StopSignal::Callback stop(signal, [&server] { server->stop(); });
    std::string status;
    for (const auto& world : worlds) status += (status.empty() ? "" : "; ") + startLine(*world, options.run);
    tellReady(status);
    server->run();
  }
  tellStopping();
  const Outcome<void> outcome = server->outcome();
  if (!outcome) sayError(outcome.error);
  if (options.hash && isPrinted) isPrinted = printHashes(worlds);
  // ends what records inputs
  server.reset();
  const bool areRecorded = !inputs || inputs->finish();
  const bool areComplete = finish(worlds);
  return isPrinted && areRecorded && areComplete && outcome ? kDone : kFailed;
}

void checkAndSchedule(const RunCommandOptions& options, Work& work) {
  passToXacro(options.xacroArguments);
  if (options.hasFile && options.file.empty()) throw UsageError("no world file given", "pongsim run WORLD");
  const std::string& worldOption = options.additions.worldOption;
  if (options.hasFile && !worldOption.empty()) {
    throw UsageError("a world file and option '" + worldOption + "' can't be used together",
                     "the option names the world: leave out '" + options.file + "'");
  }
  if (!options.world.empty() && !options.hasFile) {
    throw UsageError("option '-w' needs a world file", "pongsim run FILE -w WORLD");
  }
  if (!options.recordedInputs.empty() && !worldOption.empty()) {
    throw UsageError("options '--record-inputs' and '" + worldOption + "' can't be used together",
                     "a recording that is played has no inputs");
  }
  if (options.runAtOnce && options.run.paused) throw UsageError("options '-r' and '--paused' can't be used together");
  options.fortress.check();
  options.lockstep.check();
  work = [&options] { return runWorlds(options); };
}

void addRunCommand(CLI::App& program, Work& work, std::span<const Extension> extensions) {
  const auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = program.add_subcommand("run", "Simulate the worlds of a file, until SIGINT or SIGTERM");
  command
      ->add_option_function<std::string>(
          "WORLD",
          [options](const std::string& file) {
            options->file = file;
            options->hasFile = true;
          },
          "World or model file: a path; a name in the folders of PONGSIM_RESOURCE_PATH,\n"
          "SDF_PATH, IGN_GAZEBO_RESOURCE_PATH, GZ_SIM_RESOURCE_PATH or in pongsim's own;\n"
          "or an address on a Fuel server. Without it an empty world, 'default', is run")
      ->type_name("");
  command
      ->add_option("ARG:=VALUE", options->xacroArguments,
                   "Arguments of the xacro files that are read, of WORLD or included")
      ->type_name("");
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  addFlag("-r", options->runAtOnce, "Start running, which is the default");
  addFlag("--paused", options->run.paused, "Start paused");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  add("-w,--world", "NAME", "Run only that world of the file (all of them)", [options](const std::string& text) {
    if (text.empty()) throw UsageError("option '-w' needs a world's name");
    options->world = text;
  });
  add("--iterations", "N", "Exit when each world has run N steps; 0: never", [options](const std::string& text) {
    const std::uint64_t count = wholeNumber("--iterations", text);
    options->run.iterations = count == 0 ? std::nullopt : std::optional(count);
  });
  add("-z", "HZ", "Steps per second of wall time, instead of the world's pace; 0: as fast as possible",
      [options](const std::string& text) {
        options->run.updateRate = numberFromZero("-z", text, "a number of steps a second");
      });
  add("--seed", "N", "Random seed, 0 to 2^64-1 (0)",
      [options](const std::string& text) { options->seed = wholeNumber("--seed", text); });
  add("--threads", "N", "Move bodies on N threads, 1 to 256 (1); the result is bit-for-bit the same",
      [options](const std::string& text) {
        options->threads = static_cast<int>(wholeNumber("--threads", text, 1, 256));
      });
  add("-v,--verbose", "LEVEL", "Verbosity: 0 nothing, 1 errors, 2 warnings, 3 information, 4 everything (2)",
      [options](const std::string& text) {
        options->verbosity = static_cast<LogLevel>(wholeNumber("-v", text, 0, 4));
      });
  addFlag("--strict", options->strict,
          "Treat warnings about the file as errors, and exit with code 1 when a system fails");
  addFlag("--allow-plugin-paths", options->allowPluginPaths,
          "Load libraries that the file's <plugin>s name by a path; it can then run any code");
  addFlag("--levels", options->levels,
          "Load the contents of a <level> only while a <performer> is near (everything, always)");
  add("--record-inputs", "FILE", "Record all that comes from outside, for 'pongsim replay FILE'",
      [options](const std::string& text) {
        if (text.empty()) throw UsageError("option '--record-inputs' needs a file");
        options->recordedInputs = text;
      });
  addFlag("--hash", options->hash, "Print a hash of the state's bits at the end");
  add("--hash-every", "N", "Print that hash every N steps, too",
      [options](const std::string& text) { options->hashPeriod = wholeNumber("--hash-every", text, 1); });
  command
      ->add_option_function<std::vector<std::string>>(
          "--fault",
          [options](const std::vector<std::string>& faults) {
            for (const std::string& fault : faults) addFault(fault, options->additions.systems);
          },
          "A fault on purpose, \"drop topic=/lidar probability=0.3 from=2 to=5\"; the option can be\n"
          "repeated. TYPE is drop, duplicate, delay, noise, freeze, sensor, stick, slip or weaken;\n"
          "'pongsim plugin -i faults' and its page say more")
      ->type_name("FAULT")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addNetworkOption(*command);
  addSecureOption(*command);
  addOfflineOption(*command);
  addRendererOption(*command);
  addPackagesOption(*command);
  options->lockstep.addTo(*command);
  options->fortress.addTo(*command);
  command->footer(
      "Examples:\n"
      "  pongsim run worlds/pong_world.sdf\n"
      "  pongsim run worlds/pong_world.sdf --paused -v 3\n"
      "  pongsim run three_worlds.sdf -w maze\n"
      "  pongsim run robot.urdf.xacro wheels:=4 --packages ~/ws/src\n"
      "  pongsim run worlds/pong_world.sdf -z 0 --iterations 10000 --hash\n"
      "  pongsim run worlds/pong_world.sdf -z 0 --iterations 10000 --hash-every 1000\n"
      "  pongsim run worlds/pong_world.sdf --record-inputs run.inputs\n"
      "  pongsim run worlds/pong_lidar.sdf -z 0 --lockstep /cmd_vel:100 --lockstep-start /lidar\n"
      "  pongsim run worlds/pong_lidar.sdf --fault \"delay topic=/cmd_vel delay=0.2\" --fault \"freeze topic=/lidar "
      "from=5\"");
  for (const Extension& extension : extensions) addRunOptions(*command, extension, options->additions);
  command->callback([options, &work, command, known = std::vector(extensions.begin(), extensions.end())] {
    for (const Extension& extension : known) checkExcluded(*command, extension);
    checkAndSchedule(*options, work);
  });
}

}  // namespace

void addRunCommand(CLI::App& program, Work& work) { addRunCommand(program, work, installedExtensions()); }

void addPlainRunCommand(CLI::App& program, Work& work) { addRunCommand(program, work, {}); }

}  // namespace pongsim::cli
