#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/command.hh"
#include "cli/files/world_file.hh"
#include "cli/options/number_option.hh"
#include "cli/options/offline_option.hh"
#include "cli/replay/recorded_world.hh"
#include "cli/replay/side_by_side.hh"
#include "pongsim/log.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

struct BisectOptions {
  std::string a, b;
  std::optional<std::uint64_t> steps;
  std::optional<std::uint64_t> seed;
  int threads = 1;
  bool levels = false;
};

constexpr std::uint64_t kUsualSteps = 10'000;

/// One of the two: a world file, or a recording.
struct BisectSide {
  std::filesystem::path file;
  std::optional<sim::Recording> recording;
  sim::WorldContent content;
};

BisectSide sideOf(const std::string& name) {
  BisectSide side;
  if (sim::isRecording(name)) {
    Outcome<sim::Recording> read = sim::readRecording(name);
    if (!read) throw Failure("'" + name + "' " + read.error);
    side.recording = std::move(*read);
    if (!side.recording->cut.empty()) say("'" + name + "': " + side.recording->cut);
    side.content = contentOf(side.recording->start);
    return side;
  }
  Diagnostics diagnostics;
  const std::optional<std::filesystem::path> found = fetchWorldFile(name, diagnostics);
  if (!found) checkLoaded({}, diagnostics, false);
  side.file = *found;
  side.content = sim::contentOf(side.file).value_or(sim::WorldContent{});
  return side;
}

Worlds worldsOf(const BisectSide& side, const sim::RunStart& start, int threads) {
  Diagnostics diagnostics;
  Worlds worlds = side.recording ? loadRecorded(side.recording->start, {threads, nullptr}, diagnostics)
                                 : loadFile(side.file, start, {threads, nullptr}, diagnostics);
  checkLoaded(worlds, diagnostics, false);
  return worlds;
}

/// @return Steps without inputs.
sim::Tape stepsOnly(std::uint64_t steps) {
  sim::Passage passage;
  passage.runs.push_back({sim::Passage::Kind::kStep, steps});
  sim::Tape tape;
  tape.passages.push_back(std::move(passage));
  return tape;
}

int bisect(const BisectOptions& options) {
  const BisectSide a = sideOf(options.a);
  const BisectSide b = sideOf(options.b);
  const sim::Recording* inputs = a.recording ? &*a.recording : b.recording ? &*b.recording : nullptr;
  sim::RunStart start;
  if (inputs != nullptr) start = inputs->start;
  if (options.seed) start.seed = *options.seed;
  start.levels = start.levels || options.levels;
  const Worlds worldsA = worldsOf(a, start, options.threads);
  const Worlds worldsB = worldsOf(b, start, options.threads);
  if (worldsA.size() != worldsB.size()) throw Failure("the two do not have as many worlds as each other");
  bool isSame = true;
  for (std::size_t i = 0; i < worldsA.size(); ++i) {
    const std::string name(worldsA[i]->world().name());
    const bool hasInputs = inputs != nullptr && i < inputs->tapes.size();
    const sim::Tape tape = hasInputs ? inputs->tapes[i] : stepsOnly(options.steps.value_or(kUsualSteps));
    const auto found = compare(*worldsA[i], *worldsB[i], tape, hasInputs && start.paused, options.steps);
    if (found) print(textOf(*found, name));
    if (!found) {
      print("world '" + name + "' has the same bits up to " + placeOf(worldsA[i]->iterations(), *worldsA[i]) + "\n");
    }
    isSame = isSame && !found;
  }
  const std::string changed = firstDifference(a.content, b.content);
  if (!changed.empty()) print("first difference of the files: " + changed + "\n");
  return isSame ? kDone : kFailed;
}

}  // namespace

void addBisectCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<BisectOptions>();
  CLI::App* command = program.add_subcommand("bisect", "Find the first step in which two versions of a world differ");
  const auto addSide = [command](const char* name, std::string& target, const char* description) {
    command->add_option(name, target, description)->type_name("");
  };
  addSide("A", options->a, "World file, or recording of 'pongsim run --record-inputs'");
  addSide("B", options->b, "The other one; with a recording, both get its inputs");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  add("--steps", "N", "Compare N steps (10000; with a recording, all of it)",
      [options](const std::string& text) { options->steps = wholeNumber("--steps", text, 1); });
  add("--seed", "N", "Random seed, 0 to 2^64-1 (0, or the recording's)",
      [options](const std::string& text) { options->seed = wholeNumber("--seed", text); });
  add("--threads", "N", "Move bodies on N threads, 1 to 256 (1)", [options](const std::string& text) {
    options->threads = static_cast<int>(wholeNumber("--threads", text, 1, 256));
  });
  command->add_flag("--levels", options->levels, "Load the contents of a <level> only while a <performer> is near")
      ->disable_flag_override();
  addOfflineOption(*command);
  command->footer(
      "Exits with code 1 if the worlds differ.\n"
      "\n"
      "Examples:\n"
      "  pongsim bisect before.sdf after.sdf\n"
      "  pongsim bisect before.sdf after.sdf --steps 60000 --seed 7\n"
      "  pongsim bisect run.inputs after.sdf");
  command->callback([options, &work] {
    if (options->a.empty() || options->b.empty()) throw UsageError("two worlds are needed", "pongsim bisect A B");
    work = [options] {
      setLogLevel(LogLevel::kError);
      return bisect(*options);
    };
  });
}

}  // namespace pongsim::cli
