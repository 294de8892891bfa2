#pragma once

#include "description/world.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::sim {

/// Gives a world that lists no system of its own what the server config file lists for it and its models, in place of
/// the default systems, as Fortress does. The environment variable IGN_GAZEBO_SERVER_CONFIG_PATH, else
/// GZ_SIM_SERVER_CONFIG_PATH, names the file; where neither is set nothing is done. What is wrong with the file is
/// added to `diagnostics`: an error where it is no XML, else warnings.
/// @return Whether such a file says which systems the world has: then there are no default ones.
bool applyServerConfig(description::World& world, Diagnostics& diagnostics);

}  // namespace pongsim::sim
