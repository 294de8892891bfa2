#pragma once

#include <span>

#include "log/command/command.hh"

namespace pongsim::log {

/// Reads a whole command line of `pongsim log`, of which the program's name is the first word, and does what it says.
/// @param actions Those that it may name.
/// @return The program's exit code: 0 done, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, std::span<const AddAction> actions);

}  // namespace pongsim::log
