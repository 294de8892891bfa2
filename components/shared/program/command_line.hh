#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/program/failure.hh"

namespace CLI {
class App;
}

namespace pongsim::cli {

/// The work of a command, which runs once the command line has been parsed.
/// @return The exit code.
using Work = std::function<int()>;

/// Adds a command, or an option of the program, to `program`. The command sets `work` if the user named it; both
/// outlive the work. A command without a group is hidden from the help.
using AddCommand = void (*)(CLI::App& program, Work& work);

/// `pongsim` itself, or the program of a component, which `pongsim NAME` runs and whose commands are called actions.
struct Program {
  /// As users call it: "pongsim log".
  const char* name = "";
  /// Its purpose, in a sentence.
  const char* about = "";
  std::span<const AddCommand> commands;
  /// Text below its help; may be empty.
  const char* footer = "";
  /// Whether its commands are actions. "help" may then also follow one, as with Fortress: `pongsim log record help`.
  bool hasActions = true;
  /// Converts the words of the command line, at least one, before they are parsed. Null: no conversion.
  /// @throws UsageError
  std::vector<std::string> (*words)(std::vector<std::string> words, const CLI::App& program) = nullptr;
  /// @return What to say about an unknown word, instead of what it resembles. Null: nothing.
  /// @param command Name of the command that has no such option; empty: `word` is not a command.
  /// @param known The options, with their hyphens, or the commands.
  std::optional<UsageError> (*advice)(std::string_view command, std::string_view word,
                                      std::span<const std::string_view> known) = nullptr;
};

/// @return The program with its commands, one of which sets `work` when a command line is parsed.
std::unique_ptr<CLI::App> makeApp(const Program& program, Work& work);

/// Parses a command line. Runs nothing yet, except that it prints help if asked.
/// @param words Without the program's name.
/// @throws UsageError if it is invalid.
Work workOf(std::vector<std::string> words, const Program& program);

/// Runs work and reports why it failed. SIGPIPE and SIGXFSZ do not end the process: failed writes are handled where
/// they happen.
/// @return The exit code: that of the work, 1 if it failed, 2 for a `UsageError`.
int reportingFailures(const Work& work);

/// Parses a command line, including the program's name, and runs it.
/// @return The exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, const Program& program);

}  // namespace pongsim::cli
