#pragma once

#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<physics>` profiles of a world.
/// @return The one marked default="true", else the first, else the format's defaults.
description::PhysicsProfile readPhysics(const Element& world, Context& context);

/// Reads `<gravity>` [m/s^2], which stood in `<physics>` up to SDF 1.5.
Vector3 readGravity(const Element& world, Context& context);

}  // namespace pongsim::sdf
