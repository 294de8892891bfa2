#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::programs {

/// What is to be done once the command line has been read.
/// @return The exit code.
using Work = std::function<int()>;

/// Adds an action to `program`, which sets `work` where the user names it; both stay until the work is done. One of no
/// group is not told of.
using AddAction = void (*)(CLI::App& program, Work& work);

/// A program of a room, which `pongsim NAME` becomes.
struct Program {
  /// As the user calls it: "pongsim log".
  const char* name = "";
  /// What it is for, in a sentence.
  const char* about = "";
  std::span<const AddAction> actions;
  /// Stands behind its help; may be empty.
  const char* footer = "";
  /// Makes of the words that the user gave, of which there is one at least, those that are read. None: they are the
  /// same.
  /// @throws UsageError
  std::vector<std::string> (*words)(std::vector<std::string> words) = nullptr;
};

/// Reads a whole command line, of which the program's name is the first word, and does what it says. A reader that goes
/// away, and a limit on the size of files, is seen where the writing is done, and ends no program.
/// @return The program's exit code: 0 done, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, const Program& program);

}  // namespace pongsim::programs
