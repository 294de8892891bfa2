#pragma once

#include <memory>
#include <span>

#include "cli/command.hh"

namespace pongsim::cli {

/// Adds a subcommand, as those in `command.hh`.
using AddCommand = void (*)(CLI::App& program, Work& work);

/// @param commands What it offers, each adding its own. They set `work` where the user names them.
/// @return The program as users see it.
std::unique_ptr<CLI::App> makeProgram(std::span<const AddCommand> commands, Work& work);

/// Reads a whole command line, of which the program's name is the first word; does nothing yet, but that it prints help
/// where that is asked for.
/// @param commands Those that it may name.
/// @throws UsageError where it is wrong.
Work workOf(int argc, char** argv, std::span<const AddCommand> commands);

/// Reads a command line, and does what it says.
/// @return The program's exit code: 0 done, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, std::span<const AddCommand> commands);

}  // namespace pongsim::cli
