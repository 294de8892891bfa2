#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"

namespace pongsim::sim {

/// Prepares the worlds of a file for simulation. A file without worlds gets one around its models, lights and actors,
/// with a ground, a sun, the systems that the sensors need, and default settings.
/// @return Whether the file can be simulated; otherwise `diagnostics` has the reason.
bool prepareWorlds(sdf::Root& root, Diagnostics& diagnostics);

/// @param name Empty: the first world, with a warning for each other one.
/// @return The index of the world of that name; nothing, and an error, if there is none.
std::optional<std::size_t> chooseWorld(const std::vector<description::World>& worlds, const std::string& name,
                                       Diagnostics& diagnostics);

/// Adds an error for each world whose topic names equal those of another one: the topics of "a b" and "a_b" do.
void checkTopicNames(const std::vector<description::World>& worlds, Diagnostics& diagnostics);

}  // namespace pongsim::sim
