#pragma once

#include "cli/command.hh"
#include "pongsim/export.hh"

namespace pongsim::cli {

/// Reads a whole command line, of which the program's name is the first word; does nothing yet, but that it prints help
/// where that is asked for.
/// @throws UsageError where it is wrong.
Work workOf(int argc, char** argv);

/// The whole program.
/// @return Its exit code: 0 done, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv);

}  // namespace pongsim::cli

/// The whole program, for `main.cc` to find in the library.
extern "C" PONGSIM_API int pongsim_main(int argc, char** argv);

/// Writes the pages of the manual, `pongsim.1` and one for each command, into a folder, for `manual_main.cc`.
/// @return Whether it could.
extern "C" PONGSIM_API bool pongsim_write_manual(const char* folder);

/// Likewise the page of an extension, of which the descriptor is given.
/// @throws std::runtime_error where that can't be read.
extern "C" PONGSIM_API bool pongsim_write_extension_manual(const char* descriptor, const char* folder);
