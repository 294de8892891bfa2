#pragma once

namespace pongsim::cli {

/// @return Whether a command line is about topics and services: what it takes for that is part of the program itself,
/// which starts in half the time of the library.
bool isTalk(int argc, char** argv);

/// The program as far as it is about topics and services.
/// @return Its exit code, as that of `run`.
int talk(int argc, char** argv);

}  // namespace pongsim::cli
