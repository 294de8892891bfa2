#pragma once

namespace pongsim::cli {

/// @return Whether a command line is about topics and services: the code for those is part of the program itself, which
/// starts in half the time of the library.
bool isTalk(int argc, char** argv);

/// Runs the part of the program for topics and services.
/// @return Its exit code, see `run`.
int talk(int argc, char** argv);

}  // namespace pongsim::cli
