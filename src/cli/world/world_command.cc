#include "cli/world/world_command.hh"

#include <CLI/App.hpp>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/nearest_word.hh"
#include "cli/command.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/secure_option.hh"
#include "pongsim/log.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct WorldCommandLine {
  std::string action;
  std::optional<std::string> steps, world, lines, timeout, seed;
  bool json = false;
};

constexpr std::array<std::pair<std::string_view, WorldAction>, 6> kActions{{{"pause", WorldAction::kPause},
                                                                            {"play", WorldAction::kPlay},
                                                                            {"step", WorldAction::kStep},
                                                                            {"reset", WorldAction::kReset},
                                                                            {"stats", WorldAction::kStats},
                                                                            {"info", WorldAction::kInfo}}};

constexpr const char* kActionList = "one of pause, play, step, reset, stats, info";

WorldAction actionOf(const std::string& word) {
  std::array<std::string_view, kActions.size()> words;
  for (std::size_t i = 0; i < kActions.size(); ++i) {
    if (kActions[i].first == word) return kActions[i].second;
    words[i] = kActions[i].first;
  }
  const std::string nearest = base::didYouMean(word, words);
  throw UsageError("unknown action '" + word + "'", nearest.empty() ? kActionList : nearest);
}

Work workFor(const WorldCommandLine& given) {
  WorldOptions options;
  if (given.action.empty()) throw UsageError("no action given", kActionList);
  options.action = actionOf(given.action);
  if (given.steps && options.action != WorldAction::kStep) {
    throw UsageError("a number can't be used with '" + given.action + "'", "use it with step");
  }
  if (given.lines && options.action != WorldAction::kStats) {
    throw UsageError("option '-n' can't be used with '" + given.action + "'", "use it with stats");
  }
  if (given.seed && options.action != WorldAction::kReset) {
    throw UsageError("option '--seed' can't be used with '" + given.action + "'", "use it with reset");
  }
  if (given.json && options.action != WorldAction::kStats && options.action != WorldAction::kInfo) {
    throw UsageError("option '--json' can't be used with '" + given.action + "'", "use it with stats and info");
  }
  options.json = given.json;
  // 0 means none in the message
  constexpr std::uint32_t kLargest = std::numeric_limits<std::uint32_t>::max();
  if (given.seed) options.seed = static_cast<std::uint32_t>(wholeNumber("--seed", *given.seed, 1, kLargest));
  if (given.world) options.world = *given.world;
  if (given.world && given.world->empty()) throw UsageError("option '-w' needs a world's name");
  if (given.steps) {
    options.steps =
        static_cast<std::uint32_t>(wholeNumber("step", *given.steps, 1, std::numeric_limits<std::uint32_t>::max()));
  }
  if (given.lines) options.lines = wholeNumber("-n", *given.lines, 1);
  if (given.timeout)
    options.timeout = std::chrono::milliseconds(wholeNumber("--timeout", *given.timeout, 0, kLongestMs));
  return [options] { return controlWorld(options); };
}

}  // namespace

void addWorldCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<WorldCommandLine>();
  CLI::App* command =
      program.add_subcommand("world", "Pause, step or reset a running world, print its statistics and contents");
  const auto add = [command](const char* names, const char* value, const char* description,
                             std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    command->add_option_function<std::string>(names, keep, description)->type_name(value);
  };
  command
      ->add_option("ACTION", given->action,
                   "pause, play, step (pause, run N steps and exit when they are done),\n"
                   "reset (back to the first instant; keeps running or paused),\n"
                   "stats (one line per update, ten times a second),\n"
                   "info (what the world contains)")
      ->type_name("");
  add("N", "", "With step: number of steps (1)", given->steps);
  add("-w,--world", "WORLD", "The world's name, if several run", given->world);
  add("-n,--num", "N", "With stats: exit after N lines", given->lines);
  add("--seed", "N", "With reset: the new random seed, 1 to 2^32-1", given->seed);
  command->add_flag("--json", given->json, "With stats and info: print JSON, one object per line")
      ->disable_flag_override();
  add("--timeout", "MS", "Give up after MS milliseconds (1000) without a world or its response", given->timeout);
  addNetworkOption(*command);
  addSecureOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim run worlds/pong_world.sdf --paused &\n"
      "  pongsim world step 100\n"
      "  pongsim world reset\n"
      "  pongsim world play\n"
      "  pongsim world stats -n 10\n"
      "  pongsim world info --json");
  command->callback([given, &work] {
    work = workFor(*given);
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
