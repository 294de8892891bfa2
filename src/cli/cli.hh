#pragma once

#include <string>

#include "pongsim/export.hh"

namespace pongsim::cli {

/// The whole program.
/// @return Its exit code: 0 done, 1 the work failed, 2 the command line was wrong.
PONGSIM_API int run(int argc, char** argv);

/// Writes the pages of the manual, `pongsim.1` and one for each command, into a folder.
/// @return Whether it could.
PONGSIM_API bool writeManual(const std::string& folder);

}  // namespace pongsim::cli
