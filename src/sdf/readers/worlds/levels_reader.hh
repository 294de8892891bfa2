#pragma once

#include "description/world.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads levels and performers from the first world plugin that has any. Unusable levels and performers are left out
/// with a warning, as in Fortress.
/// @param world With its models, lights, actors and plugins.
description::LevelPlan readLevels(const description::World& world, Context& context);

}  // namespace pongsim::sdf
