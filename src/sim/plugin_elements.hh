#pragma once

#include <vector>

#include "description/plugin.hh"
#include "pongsim/element.hh"

namespace pongsim::sim {

/// Fortress's servers add this where a world lists no system of its own.
description::Plugin defaultSceneBroadcaster();

/// @return The plugins that these `<plugin>` elements stand for.
std::vector<description::Plugin> pluginsOf(const std::vector<Element>& elements);

/// @return A plugin of the file with what is said of the same system elsewhere, which is taken from `more`.
description::Plugin joined(description::Plugin plugin, std::vector<description::Plugin>& more);

}  // namespace pongsim::sim
