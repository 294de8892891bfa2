#include "cli/fortress/fortress_words.hh"

#include <algorithm>

namespace pongsim::cli {

namespace {

/// A command and the package that provides it.
struct CommandOfPackage {
  std::string_view name;
  std::string_view package;
};
constexpr CommandOfPackage kCommandPackages[] = {
    {"fuel", "pongsim-fuel"}, {"log", "pongsim-log"}, {"ros2", "pongsim-ros2"}};

/// Prefixes of options of `run`, and the packages that provide them.
constexpr CommandOfPackage kRunPackages[] = {
    {"--record", "pongsim-log"}, {"--playback", "pongsim-log"}, {"--log-", "pongsim-log"}, {"--ros2", "pongsim-ros2"}};

struct Answer {
  std::string_view word;
  std::string_view message;
  std::string_view hint;
};

constexpr Answer kAbsentCommands[] = {
    {"gui", "pongsim has no GUI", "'pongsim view' renders a world, 'pongsim topic -e --plot' what a sensor measures"},
    {"launch", "pongsim does not run launch files", "start the programs in a script: pongsim run WORLD &"},
    {"param", "pongsim has no parameter registries", "systems take parameters in their <plugin>, and have services"},
    {"gazebo", "'gazebo' is 'run' here", "pongsim run WORLD"},
    {"sim", "'sim' is 'run' here", "pongsim run WORLD"}};

/// Options of the program `ign`, which a link named `ign` to pongsim supports.
constexpr Answer kOptionsOfIgn[] = {
    {"--version", "'--version' can't be combined with other options", "pongsim --version"},
    {"--versions", "there is one version of pongsim", "pongsim --version"},
    {"--force-version", "there is only one version of pongsim: see 'pongsim --version'", "leave it out"}};

std::optional<Advice> missing(std::string_view word, std::string_view package) {
  return Advice{"'" + std::string(word) + "' is in the package " + std::string(package) + ", which is not installed",
                "apt-get install " + std::string(package)};
}

template <class Answers>
std::optional<Advice> answerTo(const Answers& answers, std::string_view word) {
  const auto* found = std::ranges::find(answers, word, &Answer::word);
  if (found == std::end(answers)) return std::nullopt;
  return Advice{std::string(found->message), std::string(found->hint)};
}

}  // namespace

std::optional<Advice> adviceOnCommand(std::string_view name) {
  const auto* package = std::ranges::find(kCommandPackages, name, &CommandOfPackage::name);
  if (package != std::end(kCommandPackages)) return missing(name, package->package);
  return answerTo(kAbsentCommands, name);
}

std::optional<Advice> adviceOnOption(std::string_view command, std::string_view option,
                                     std::span<const std::string_view> known) {
  for (const CommandOfPackage& each : kRunPackages) {
    const auto isOfIt = [&each](std::string_view name) { return name.starts_with(each.name); };
    if (command == "run" && isOfIt(option) && std::ranges::none_of(known, isOfIt)) return missing(option, each.package);
  }
  return answerTo(kOptionsOfIgn, option);
}

}  // namespace pongsim::cli
