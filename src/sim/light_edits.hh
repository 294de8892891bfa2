#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/message.hh"
#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"
#include "sim/access.hh"

namespace pongsim::sim {

// Lights that come, change and go between two steps. What is refused changes nothing.

/// Adds a light of the world that is as the message says.
/// @param options Their name and pose count before those of the message.
/// @return Its name, or why not.
Outcome<std::string> insertLight(Access& access, const Message& light, const InsertOptions& options);

/// Lets the light that the message names be as it says: see `msgs::changedLight`.
/// @return Why not, or nothing; likewise below.
std::optional<std::string> changeLight(Access& access, const Message& light);

/// Removes a light of the world.
/// @param id 0: it is named by its name.
std::optional<std::string> removeLight(Access& access, std::uint64_t id, const std::string& name);

}  // namespace pongsim::sim
