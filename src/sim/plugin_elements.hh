#pragma once

#include <vector>

#include "description/plugin.hh"
#include "pongsim/element.hh"

namespace pongsim::sim {

/// @return The scene broadcaster, which Fortress's server adds to a world without systems of its own.
description::Plugin defaultSceneBroadcaster();

/// @return The plugins described by these `<plugin>` elements.
std::vector<description::Plugin> pluginsOf(const std::vector<Element>& elements);

/// @return `plugin` with the parameters that `more` has for the same system, which take precedence; that element is
/// removed from `more`.
description::Plugin joined(description::Plugin plugin, std::vector<description::Plugin>& more);

}  // namespace pongsim::sim
