#pragma once

#include <string>

#include "pongsim/system.hh"

namespace pongsim::log {

/// Reports that a system can't record or play. As in Fortress, the world runs without a system that its file names. It
/// does not load without one that the program added, as for `pongsim run --record`.
/// @throws Error with the reason, in the first case.
void leaveOut(const SystemContext& context, const std::string& why, const std::string& hint = {});

}  // namespace pongsim::log
