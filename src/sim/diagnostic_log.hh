#pragma once

#include <string>

#include "pongsim/diagnostic.hh"
#include "pongsim/log.hh"

namespace pongsim::sim {

/// Tells what is wrong in the messages of a run.
/// @return The first error in one line, "sdf:1:1: model 'r' has no link"; empty where there is none.
std::string logDiagnostics(const Diagnostics& diagnostics, const Logger& log);

/// As `logDiagnostics`, for who tells of the errors himself: they are returned only.
std::string logWarnings(const Diagnostics& diagnostics, const Logger& log);

}  // namespace pongsim::sim
