#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/report/crash_report.hh"
#include "cli/command.hh"
#include "cli/help/version.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/offline_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/replay/recorded_world.hh"
#include "cli/replay/side_by_side.hh"
#include "cli/stop_signal.hh"
#include "pongsim/log.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "sim/api/access.hh"
#include "sim/inputs/inside.hh"
#include "sim/inputs/replay.hh"
#include "sim/running/server.hh"

namespace pongsim::cli {

namespace {

struct ReplayOptions {
  std::string file;
  std::string world;
  std::optional<std::uint64_t> until;
  bool isLive = false;
  bool isPaused = false;
  int threads = 1;
  LogLevel verbosity = LogLevel::kError;
};

constexpr std::size_t kMostLines = 8;

/// Where the replayed worlds come from.
struct ReplayedFile {
  /// Empty: from the recording.
  std::filesystem::path path;
  /// Where it differs from the recorded one; empty: nowhere.
  std::string change;
};

ReplayedFile fileFor(const sim::RunStart& start, const ReplayOptions& options) {
  ReplayedFile file{options.world.empty() ? start.file : options.world, {}};
  if (file.path.empty()) return file;
  const std::optional<sim::WorldContent> now = sim::contentOf(file.path);
  if (now) {
    file.change = firstDifference(contentOf(start), *now);
    return file;
  }
  if (!options.world.empty()) throw Failure("'" + options.world + "' is not a world that can be read");
  say("'" + start.file + "' can't be read: the world is taken from the recording");
  return {};
}

/// What a replay of one world has shown.
struct Result {
  bool isAsRecorded = true;
  bool isStopped = false;
  /// Lines to print.
  std::string text;
};

/// Where a replay left what was recorded, until the values of a recorded state show in what.
class Departure {
 public:
  /// After a step with other bits than recorded.
  void begin(const sim::Replay& replay, const Simulation& simulation) {
    if (!place_.empty()) return;
    place_ = placeOf(replay.steps(), simulation);
  }
  /// After each step since.
  /// @return Whether the first recorded state shows what differs.
  bool add(const sim::Replay& replay, const Simulation& simulation) {
    add(replay);
    const sim::StateValues* recorded = replay.recordedState();
    if (recorded == nullptr) return false;
    const sim::StateValues now = sim::StateValues::of(sim::Inside::access(simulation));
    const std::vector<std::string> found = differences(*recorded, now, kMostLines);
    if (!found.empty()) lines_ += "  at " + placeOf(replay.steps(), simulation) + ", recorded and now:\n";
    for (const std::string& line : found) lines_ += "    " + line + "\n";
    return true;
  }
  bool hasBegun() const { return !place_.empty(); }
  std::string text() const { return " differs from what was recorded from " + place_ + " on\n" + lines_; }

 private:
  void add(const sim::Replay& replay) {
    for (const std::string& what : replay.missing()) lines_ += "  the world lacks " + what + "\n";
  }

  std::string place_;
  std::string lines_;
};

Result replayWorld(Simulation& simulation, const sim::Tape& tape, bool paused, const ReplayOptions& options,
                   const StopSignal& signal, bool& endsPaused) {
  sim::Replay replay(tape, simulation, paused);
  Departure departure;
  Result result;
  bool isKnown = false;
  while (!isKnown && !(result.isStopped = signal.stopped()) && replay.advance()) {
    if (!replay.isAsRecorded()) departure.begin(replay, simulation);
    if (departure.hasBegun()) isKnown = departure.add(replay, simulation);
    if (options.until && replay.steps() >= *options.until) break;
  }
  const std::string name = "world '" + std::string(simulation.world().name()) + "'";
  result.isAsRecorded = !departure.hasBegun();
  result.text = name + (result.isAsRecorded ? " is as recorded up to " + placeOf(replay.steps(), simulation) + ", " +
                                                  hashText(simulation.stateHash()) + "\n"
                                            : departure.text());
  if (tape.unrecordedAfter && *tape.unrecordedAfter < replay.steps()) {
    result.text += "  after step " + std::to_string(*tape.unrecordedAfter) +
                   " the run was changed by something else than messages and requests, which is not recorded\n";
  }
  if (options.until && !options.isLive) {
    result.text += textOf(sim::StateValues::of(sim::Inside::access(simulation)));
  }
  endsPaused = replay.isPaused();
  return result;
}

/// Compares worlds with the recorded ones side by side, after they were changed.
/// @return Whether all have the same bits.
bool compareWithRecorded(const sim::Recording& recording, const ReplayedFile& file, const ReplayOptions& options) {
  const auto load = [&](bool isRecorded) {
    Diagnostics diagnostics;
    const WorldLoading loading{options.threads, nullptr};
    Worlds worlds = isRecorded ? loadRecorded(recording.start, loading, diagnostics)
                               : loadFile(file.path, recording.start, loading, diagnostics);
    checkLoaded(worlds, diagnostics, false);
    return worlds;
  };
  const Worlds before = load(true);
  const Worlds now = load(false);
  if (before.size() != now.size()) throw Failure("there are not as many worlds as there were");
  bool isSame = true;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto found = compare(*before[i], *now[i], recording.tapes[i], recording.start.paused, options.until);
    const std::string name(now[i]->world().name());
    if (found) {
      print(textOf(*found, name));
      if (!found->isFirstAsRecorded) {
        print("  the first is the recorded world by this program, which no longer has the recorded bits either\n");
      }
    } else {
      print("world '" + name + "' has the recorded bits\n");
    }
    isSame = isSame && !found;
  }
  return isSame;
}

int goLive(Transport& transport, const Worlds& worlds, bool paused, StopSignal& signal) {
  transport.announce();
  say("goes on with the network" + std::string(paused ? ", paused" : ""));
  sim::RunOptions run;
  run.paused = paused;
  sim::Server server(transport, worlds, run);
  const StopSignal::Callback stop(signal, [&server] { server.stop(); });
  server.run();
  for (const auto& world : worlds) {
    if (const Outcome<void> finished = world->finish(); !finished) return fail(finished.error);
  }
  return kDone;
}

int replay(const ReplayOptions& options) {
  setLogLevel(options.verbosity);
  base::reportCrashes();
  StopSignal signal;
  Outcome<sim::Recording> read = sim::readRecording(options.file);
  if (!read) throw Failure("'" + options.file + "' " + read.error);
  const sim::Recording& recording = *read;
  if (!recording.cut.empty()) say("'" + options.file + "': " + recording.cut + ", and is replayed up to there");
  const ReplayedFile file = fileFor(recording.start, options);
  if (!file.change.empty()) {
    say("the world has changed since: " + file.change);
    if (!options.isLive) return compareWithRecorded(recording, file, options) ? kDone : kFailed;
  }
  if (recording.start.version != versionText()) say("the recording is of another version of pongsim");

  std::optional<Transport> transport;
  if (options.isLive) transport.emplace(TransportOptions{.announceLater = true});
  const WorldLoading loading{options.threads, transport ? &*transport : nullptr};
  Diagnostics diagnostics;
  const Worlds worlds = file.path.empty() ? loadRecorded(recording.start, loading, diagnostics)
                                          : loadFile(file.path, recording.start, loading, diagnostics);
  checkLoaded(worlds, diagnostics, options.verbosity >= LogLevel::kWarning);
  if (worlds.size() != recording.tapes.size()) throw Failure("there are not as many worlds as there were");
  bool isAsRecorded = true;
  bool endsPaused = false;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const Result result =
        replayWorld(*worlds[i], recording.tapes[i], recording.start.paused, options, signal, endsPaused);
    if (!print(result.text)) return kFailed;
    if (result.isStopped) return kFailed;
    isAsRecorded = isAsRecorded && result.isAsRecorded;
  }
  if (!options.isLive) return isAsRecorded ? kDone : kFailed;
  return goLive(*transport, worlds, endsPaused || options.isPaused, signal);
}

}  // namespace

void addReplayCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = program.add_subcommand("replay", "Run a world again with the inputs of a recorded run");
  command->add_option("FILE", options->file, "Recording of 'pongsim run --record-inputs FILE'")->type_name("");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  add("--until", "STEP", "Stop after that many steps, and print the state",
      [options](const std::string& text) { options->until = wholeNumber("--until", text, 1); });
  command
      ->add_flag("--live", options->isLive,
                 "Go on from the end, or from --until, with the network and what connects to it")
      ->disable_flag_override();
  command->add_flag("--paused", options->isPaused, "With --live: go on paused")->disable_flag_override();
  add("--with", "FILE", "Replay with this world file, instead of the one that was recorded",
      [options](const std::string& text) { options->world = text; });
  add("--threads", "N", "Move bodies on N threads, 1 to 256 (1); the result is bit-for-bit the same",
      [options](const std::string& text) {
        options->threads = static_cast<int>(wholeNumber("--threads", text, 1, 256));
      });
  add("-v,--verbose", "LEVEL", "Verbosity: 0 nothing, 1 errors, 2 warnings, 3 information, 4 everything (1)",
      [options](const std::string& text) {
        options->verbosity = static_cast<LogLevel>(wholeNumber("-v", text, 0, 4));
      });
  addNetworkOption(*command);
  addSecureOption(*command);
  addOfflineOption(*command);
  command->footer(
      "Exits with code 1 if the state is not bit for bit as recorded.\n"
      "\n"
      "Examples:\n"
      "  pongsim run worlds/pong_world.sdf --record-inputs run.inputs\n"
      "  pongsim replay run.inputs\n"
      "  pongsim replay run.inputs --threads 4\n"
      "  pongsim replay run.inputs --until 5000\n"
      "  pongsim replay run.inputs --until 5000 --live --paused");
  command->callback([options, &work] {
    if (options->file.empty()) throw UsageError("no recording given", "pongsim replay FILE");
    if (options->isPaused && !options->isLive) throw UsageError("option '--paused' needs '--live'");
    work = [options] { return replay(*options); };
  });
}

}  // namespace pongsim::cli
