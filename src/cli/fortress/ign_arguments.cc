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

/// The commands, with the version of their library in Fortress.
constexpr std::pair<std::string_view, std::string_view> kIgnCommands[] = {
    {"fuel", "7"},   {"gazebo", "6"}, {"log", "11"}, {"model", "6"},    {"msg", "8"},
    {"plugin", "1"}, {"sdf", "12"},   {"sim", "6"},  {"service", "11"}, {"topic", "11"}};

bool isNumber(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// @return The version of Fortress's command; empty if the command is not supported here.
std::string_view versionOf(std::string_view command) {
  const auto* found = std::ranges::find(kIgnCommands, command, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kIgnCommands) ? std::string_view() : found->second;
}

/// @param wanted "6", or "6.16.0".
void checkVersion(std::string_view command, std::string_view wanted) {
  const std::string_view version = versionOf(command);
  if (wanted.substr(0, wanted.find('.')) == version) return;
  throw UsageError("there is no version '" + std::string(wanted) + "' of '" + std::string(command) + "' here",
                   "it does the same as version " + std::string(version) + " of Fortress: leave out --force-version");
}

/// @return The flags joined in a word ("sr" in "-srv4"), and what follows them ("v4").
std::pair<std::string_view, std::string_view> joinedFlags(std::string_view word) {
  if (word.size() < 2 || word[0] != '-' || word[1] == '-') return {};
  const std::size_t end = std::min(word.find_first_not_of("srgh", 1), word.size());
  return {word.substr(1, end - 1), word.substr(end)};
}

std::string commandNames() {
  std::string text;
  for (const auto& [name, version] : kIgnCommands) text += std::string(name) + "\n";
  return text;
}

using Words = std::vector<std::string>;

/// Checks and removes `--force-version VERSION`.
Words withoutForcedVersion(std::string_view command, std::span<const std::string> words) {
  constexpr std::string_view kOption = "--force-version";
  Words rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == kOption) {
      if (++i == words.size()) throw UsageError("option '" + std::string(kOption) + "' needs a value");
      checkVersion(command, words[i]);
    } else if (words[i].starts_with(std::string(kOption) + "=")) {
      checkVersion(command, std::string_view(words[i]).substr(kOption.size() + 1));
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

Words talkArguments(const std::string& command, const Words& words) {
  Words result = {command};
  for (const std::string& word : words) result.push_back(word == "--help-all" ? "--help" : word);
  return result;
}

}  // namespace

bool isCalledAsIgn(std::string_view program) {
  const std::size_t slash = program.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? program : program.substr(slash + 1);
  return name == "ign" || name == "gz";
}

IgnLine fromIgnArguments(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return {};
  if (arguments.front() == "--commands") return {{}, commandNames()};
  if (arguments.front() == "help") {
    if (arguments.size() == 1) return {{"--help"}};
    return fromIgnArguments({arguments[1], "--help"});
  }
  const std::string& command = arguments.front();
  const std::string version(versionOf(command));
  if (version.empty()) return {arguments};

  const Words words = withoutForcedVersion(command, std::span(arguments).subspan(1));
  const auto has = [&words](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
  if (has("--versions")) return {{}, version + "\n"};
  const bool isTalk = command == "topic" || command == "service";
  if (has("--version") || (isTalk && has("-v"))) {
    return {{}, "pongsim " PONGSIM_VERSION ", which does what '" + command + "' of version " + version + " does\n"};
  }
  if (command == "gazebo" || command == "sim") return {runArguments(words)};
  if (isTalk) return {talkArguments(command, words)};

  Words result = {command};
  result.insert(result.end(), words.begin(), words.end());
  // `plugin` is always verbose
  if (command == "plugin") std::erase_if(result, [](const auto& word) { return word == "-v" || word == "--verbose"; });
  if (command == "msg" || command == "model") result.emplace_back("--as-ign");
  return {result};
}

}  // namespace pongsim::cli
