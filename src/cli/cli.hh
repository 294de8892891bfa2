#pragma once

#include "pongsim/export.hh"

namespace pongsim::cli {

/// The whole program.
/// @return Its exit code: 0 done, 1 the work failed, 2 the command line was wrong.
PONGSIM_API int run(int argc, char** argv);

}  // namespace pongsim::cli
