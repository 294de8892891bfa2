#pragma once

#include <span>

#include "shared/program/command_line.hh"

namespace pongsim::cli {

/// @return `pongsim` with these commands.
Program programWith(std::span<const AddCommand> commands);

/// Parses a whole command line, including the program's name, which may be `ign` or `gz` (`ign_arguments.hh`). Runs
/// nothing yet, except that it prints help if asked.
/// @throws UsageError if it is invalid.
Work workOf(int argc, char** argv, std::span<const AddCommand> commands);

/// Parses a command line and runs it.
/// @return The program's exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, std::span<const AddCommand> commands);

}  // namespace pongsim::cli
