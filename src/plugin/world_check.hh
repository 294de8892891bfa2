#pragma once

#include "description/model.hh"
#include "description/world.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::plugin {

/// Reports what running the world would report of its plugins and of sensors that none of them simulates, without
/// configuring a system.
void checkPlugins(const description::World& world, Diagnostics& diagnostics);

/// Reports the same of the plugins of a model outside of any world.
void checkPlugins(const description::Model& model, Diagnostics& diagnostics);

}  // namespace pongsim::plugin
