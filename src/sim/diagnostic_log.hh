#pragma once

#include <string>

#include "pongsim/diagnostic.hh"
#include "pongsim/log.hh"

namespace pongsim::sim {

/// Logs errors and warnings of a run.
/// @return The first error in one line, "sdf:1:1: model 'r' has no link"; empty without errors.
std::string logDiagnostics(const Diagnostics& diagnostics, const Logger& log);

/// Like `logDiagnostics`, but errors are only returned, for callers that report them.
std::string logWarnings(const Diagnostics& diagnostics, const Logger& log);

}  // namespace pongsim::sim
