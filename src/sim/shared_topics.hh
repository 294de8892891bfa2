#pragma once

#include <memory>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

/// Warns of topics by which worlds that run beside each other get at each other: those on which two of them publish,
/// and those on which one hears what another one publishes, for then its steps are the same in each run no more.
/// @param positions Where each of the worlds stands in its file.
void warnOfSharedTopics(const std::vector<std::unique_ptr<Simulation>>& worlds,
                        const std::vector<SourcePosition>& positions, Diagnostics& diagnostics);

}  // namespace pongsim::sim
