#pragma once

#include <memory>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Warns about topics that connect worlds of one process: topics on which two worlds publish, and topics on which one
/// world subscribes to what another publishes, because the subscriber's run is then not reproducible.
/// @param positions Position of each world in its file.
void warnOfSharedTopics(const std::vector<std::unique_ptr<Simulation>>& worlds,
                        const std::vector<SourcePosition>& positions, Diagnostics& diagnostics);

}  // namespace pongsim::sim
