#pragma once

#include <span>

#include "ros2/command/command.hh"

namespace pongsim::ros2 {

/// Adds an action, like those in `command.hh`.
using AddAction = void (*)(CLI::App& program, Work& work);

/// Parses a whole command line of `pongsim ros2`, including the program's name, and runs it.
/// @param actions The available actions.
/// @return The program's exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv, std::span<const AddAction> actions);

}  // namespace pongsim::ros2
