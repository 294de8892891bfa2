#include "cli/fortress/ign_arguments.hh"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <span>
#include <utility>

#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The level that `-v` alone means for `ign`.
constexpr const char* kVerbose = "3";

/// A command, with the version of its library in Fortress, and those in Garden and in Jetty.
struct Command {
  std::string_view name;
  int fortress, garden, jetty;
};
constexpr Command kCommands[] = {{"fuel", 7, 8, 11}, {"gazebo", 6, 7, 10}, {"log", 11, 12, 15}, {"model", 6, 7, 10},
                                 {"msg", 8, 9, 12},  {"plugin", 1, 2, 4},  {"sdf", 12, 13, 16}, {"service", 11, 12, 15},
                                 {"sim", 6, 7, 10},  {"topic", 11, 12, 15}};

/// Commands whose `-v` prints the version.
constexpr std::string_view kWithShortVersion[] = {"model", "sdf", "service", "topic"};

/// Commands that print names of message types.
constexpr std::string_view kWithTypes[] = {"msg", "service", "topic"};

bool isNumber(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != std::end(words);
}

/// @return The versions that a command stands for, the newest first, as `gz` lists what is installed.
std::vector<std::string> versionsOf(GazeboProgram program, const Command& command) {
  if (program == GazeboProgram::kIgn) return {std::to_string(command.fortress)};
  std::vector<std::string> versions;
  for (int version = command.jetty; version >= command.garden; --version) versions.push_back(std::to_string(version));
  return versions;
}

/// @return "version 6 of Fortress", "versions 7 to 10 of Garden to Jetty".
std::string describedVersions(GazeboProgram program, const Command& command) {
  if (program == GazeboProgram::kIgn) return "version " + std::to_string(command.fortress) + " of Fortress";
  return "versions " + std::to_string(command.garden) + " to " + std::to_string(command.jetty) + " of Garden to Jetty";
}

/// @param wanted "6", or "6.16.0".
void checkVersion(GazeboProgram program, const Command& command, std::string_view wanted) {
  if (contains(versionsOf(program, command), wanted.substr(0, wanted.find('.')))) return;
  throw UsageError("there is no version '" + std::string(wanted) + "' of '" + std::string(command.name) + "' here",
                   "it does the same as " + describedVersions(program, command) + ": leave out --force-version");
}

/// @return The flags joined in a word ("sr" in "-srv4"), and what follows them ("v4").
std::pair<std::string_view, std::string_view> joinedFlags(std::string_view word) {
  if (word.size() < 2 || word[0] != '-' || word[1] == '-') return {};
  const std::size_t end = std::min(word.find_first_not_of("srgh", 1), word.size());
  return {word.substr(1, end - 1), word.substr(end)};
}

std::string commandNames() {
  std::string text;
  for (const Command& command : kCommands) text += std::string(command.name) + "\n";
  return text;
}

using Words = std::vector<std::string>;

/// Checks and removes `--force-version VERSION`.
Words withoutForcedVersion(GazeboProgram program, const Command& command, std::span<const std::string> words) {
  constexpr std::string_view kOption = "--force-version";
  Words rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == kOption) {
      if (++i == words.size()) throw UsageError("option '" + std::string(kOption) + "' needs a value");
      checkVersion(program, command, words[i]);
    } else if (words[i].starts_with(std::string(kOption) + "=")) {
      checkVersion(program, command, std::string_view(words[i]).substr(kOption.size() + 1));
    } else {
      rest.push_back(words[i]);
    }
  }
  return rest;
}

/// `ign gazebo` is `pongsim run`, but starts paused without `-r`, and its `-v` needs no number.
Words runArguments(const Words& words) {
  Words result = {"run"};
  bool runs = false, isForHelp = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto [flags, rest] = joinedFlags(word);
    runs = runs || flags.find('r') != std::string_view::npos;
    isForHelp = isForHelp || word == "-h" || word == "--help";
    result.push_back(word);
    const bool asksForVerbosity = word == "--verbose" || rest == "v";
    if (asksForVerbosity && (i + 1 == words.size() || !isNumber(words[i + 1]))) result.emplace_back(kVerbose);
  }
  if (!runs && !isForHelp) result.emplace_back("--paused");
  return result;
}

}  // namespace

std::optional<GazeboProgram> calledAs(std::string_view program) {
  const std::size_t slash = program.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? program : program.substr(slash + 1);
  if (name == "ign") return GazeboProgram::kIgn;
  if (name == "gz") return GazeboProgram::kGz;
  return std::nullopt;
}

IgnLine fromIgnArguments(GazeboProgram program, const std::vector<std::string>& arguments) {
  if (arguments.empty()) return {};
  if (arguments.front() == "--commands") return {{}, commandNames()};
  if (arguments.front() == "help") {
    if (arguments.size() == 1) return {{"--help"}};
    return fromIgnArguments(program, {arguments[1], "--help"});
  }
  const auto* const command = std::ranges::find(kCommands, arguments.front(), &Command::name);
  if (command == std::end(kCommands)) return {arguments};

  Words words = withoutForcedVersion(program, *command, std::span(arguments).subspan(1));
  if (contains(words, "--versions")) {
    std::string text;
    for (const std::string& version : versionsOf(program, *command)) text += version + "\n";
    return {{}, text};
  }
  if (contains(words, "--version") || (contains(kWithShortVersion, command->name) && contains(words, "-v"))) {
    return {{},
            "pongsim " PONGSIM_VERSION ", which does what '" + std::string(command->name) + "' of " +
                describedVersions(program, *command) + " does\n"};
  }
  if (command->name == "gazebo" || command->name == "sim") return {runArguments(words)};
  // `plugin` is always verbose
  if (command->name == "plugin")
    std::erase_if(words, [](const auto& word) { return word == "-v" || word == "--verbose"; });
  std::ranges::replace(words, "--help-all", "--help");

  Words result = {std::string(command->name)};
  result.insert(result.end(), words.begin(), words.end());
  const bool isIgn = program == GazeboProgram::kIgn;
  if (command->name == "model" || (isIgn && command->name == "msg")) result.emplace_back("--as-ign");
  if (!isIgn && contains(kWithTypes, command->name)) result.emplace_back("--as-gz");
  return {result};
}

}  // namespace pongsim::cli
