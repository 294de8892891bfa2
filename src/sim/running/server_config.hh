#pragma once

#include "description/world.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::sim {

/// Adds the systems of the server config file to a world without systems and to its models, instead of the default
/// systems, as in Fortress. The environment variable IGN_GAZEBO_SERVER_CONFIG_PATH, else GZ_SIM_SERVER_CONFIG_PATH,
/// names the file; without them nothing happens. `diagnostics` gets an error if the file is not XML, and warnings
/// otherwise.
/// @return Whether such a file sets the world's systems, so that there are no default ones.
bool applyServerConfig(description::World& world, Diagnostics& diagnostics);

}  // namespace pongsim::sim
