#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"

namespace pongsim::sim {

/// Makes the worlds of a file simulable: a file without worlds gets one around its models, lights and actors, with a
/// ground, a sun, the systems that their sensors need, and the defaults of a world.
/// @return Whether the file can be simulated; otherwise `diagnostics` has the reason.
bool prepareWorlds(sdf::Root& root, Diagnostics& diagnostics);

/// @param name Empty: the first world, with a warning for each other one.
/// @return The number of the world of that name; nothing, and an error added, if there is none.
std::optional<std::size_t> chooseWorld(const std::vector<description::World>& worlds, const std::string& name,
                                       Diagnostics& diagnostics);

/// Adds an error for each world whose topics have the names of another one's, for "a b" and "a_b" have the same.
void checkTopicNames(const std::vector<description::World>& worlds, Diagnostics& diagnostics);

}  // namespace pongsim::sim
