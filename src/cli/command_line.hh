#pragma once

#include <memory>
#include <span>

#include "cli/command.hh"

namespace pongsim::cli {

/// Adds a subcommand, like those in `command.hh`.
using AddCommand = void (*)(CLI::App& program, Work& work);

/// @param commands Each adds its own subcommand, which sets `work` if the user names it.
/// @return The program as users see it.
std::unique_ptr<CLI::App> makeProgram(std::span<const AddCommand> commands, Work& work);

/// Parses a whole command line, including the program's name. Runs nothing yet, except that it prints help if asked.
/// @param commands The available commands.
/// @throws UsageError if it is invalid.
Work workOf(int argc, char** argv, std::span<const AddCommand> commands);

/// Parses a command line and runs it.
/// @return The program's exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, std::span<const AddCommand> commands);

}  // namespace pongsim::cli
