#pragma once

#include <memory>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Warns about topics that connect worlds running at once: those on which two of them publish, and those on which one
/// subscribes to what another publishes, since its run is then not reproducible.
/// @param positions Position of each world in its file.
void warnOfSharedTopics(const std::vector<std::unique_ptr<Simulation>>& worlds,
                        const std::vector<SourcePosition>& positions, Diagnostics& diagnostics);

}  // namespace pongsim::sim
