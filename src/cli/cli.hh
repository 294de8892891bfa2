#pragma once

#include "cli/command.hh"
#include "pongsim/export.hh"

namespace pongsim::cli {

/// Parses a whole command line, including the program's name. Runs nothing yet, except that it prints help if asked.
/// @throws UsageError if it is invalid.
Work workOf(int argc, char** argv);

/// Runs the whole program.
/// @return Its exit code: 0 success, 1 the work failed, 2 the command line was wrong.
int run(int argc, char** argv);

}  // namespace pongsim::cli

/// Runs the whole program; `main.cc` finds it in the library.
extern "C" PONGSIM_API int pongsim_main(int argc, char** argv);

/// Writes the manual's pages, `pongsim.1` and one for each command, into a folder, for `manual_main.cc`.
/// @return Whether it succeeded.
extern "C" PONGSIM_API bool pongsim_write_manual(const char* folder);

/// The same for the page of an extension with this descriptor.
/// @throws std::runtime_error if the descriptor can't be read.
extern "C" PONGSIM_API bool pongsim_write_extension_manual(const char* descriptor, const char* folder);
