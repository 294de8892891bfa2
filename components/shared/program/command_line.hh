#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::programs {

/// The work of an action, which runs once the command line has been parsed.
/// @return The exit code.
using Work = std::function<int()>;

/// Adds an action to `program`. The action sets `work` if the user chose it; both outlive the work. An action without a
/// group is hidden from the help.
using AddAction = void (*)(CLI::App& program, Work& work);

/// The program of a component, which `pongsim NAME` runs.
struct Program {
  /// The user's command: "pongsim log".
  const char* name = "";
  /// Its purpose, in a sentence.
  const char* about = "";
  std::span<const AddAction> actions;
  /// Text below its help; may be empty.
  const char* footer = "";
  /// Converts the words of the command line, at least one, before they are parsed. Null: no conversion.
  /// @throws UsageError
  std::vector<std::string> (*words)(std::vector<std::string> words) = nullptr;
};

/// Parses a command line, whose first word is the program's name, and runs the action. SIGPIPE and SIGXFSZ do not end
/// the program: failed writes are handled where they happen.
/// @return The exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, const Program& program);

}  // namespace pongsim::programs
