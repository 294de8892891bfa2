#include "cli/command_line.hh"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/extension/optional_values.hh"
#include "cli/fortress/fortress_words.hh"
#include "cli/fortress/ign_arguments.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

std::optional<UsageError> adviceOn(std::string_view command, std::string_view word,
                                   std::span<const std::string_view> known) {
  const auto advice = command.empty() ? adviceOnCommand(word) : adviceOnOption(command, word, known);
  return advice ? std::optional<UsageError>(std::in_place, advice->message, advice->hint) : std::nullopt;
}

/// @return Whether it is `pongsim --versions`, or `pongsim run --versions`: what `ign` and `gz` print with their
/// numbers.
bool asksForVersions(const std::vector<std::string>& words) {
  return !words.empty() && words.size() <= 2 && words.back() == "--versions";
}

}  // namespace

Program programWith(std::span<const AddCommand> commands) {
  return {
      .name = "pongsim",
      .about = "pongsim simulates the robots of a Gazebo world, headless.",
      .commands = commands,
      .footer =
          "Examples:\n"
          "  pongsim run worlds/pong_world.sdf\n"
          "  pongsim topic --list\n"
          "  pongsim topic --help\n"
          "\n"
          "Environment:\n"
          "  PONGSIM_DOMAIN         DDS domain, 0 to 232 (0): processes in different domains do not see each other\n"
          "  PONGSIM_NETWORK        network interface for other machines, by name or address\n"
          "  PONGSIM_SECURITY       keystore, or KEYSTORE/NAME, to secure all topics and services\n"
          "  PONGSIM_RENDERER       what draws: software, egl or auto, like --renderer\n"
          "  PONGSIM_PLUGIN_PATH    folders of systems, searched before pongsim's own\n"
          "  PONGSIM_RESOURCE_PATH  folders of worlds and models",
      .hasActions = false,
      .words = withOptionalValuesLast,
      .advice = adviceOn};
}

Work workOf(int argc, char** argv, std::span<const AddCommand> commands) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const std::optional<GazeboProgram> gazebo = argc > 0 ? calledAs(argv[0]) : std::nullopt;
  IgnLine line = gazebo ? fromIgnArguments(*gazebo, words) : IgnLine{std::move(words)};
  if (!gazebo && asksForVersions(line.arguments)) line.text = PONGSIM_VERSION "\n";
  if (line.text) return [text = *line.text] { return print(text) ? kDone : kFailed; };
  return workOf(std::move(line.arguments), programWith(commands));
}

int run(int argc, char** argv, std::span<const AddCommand> commands) {
  return reportingFailures([&] { return workOf(argc, argv, commands)(); });
}

}  // namespace pongsim::cli
