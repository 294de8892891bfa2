#pragma once

#include <vector>

#include "description/physics_profile.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<physics>` profiles of a world, in the order of the file.
std::vector<description::PhysicsProfile> readPhysics(const Element& world, Context& context);

/// @return The first profile marked as default, else the first one, else the format's defaults.
description::PhysicsProfile chosenProfile(const std::vector<description::PhysicsProfile>& profiles);

/// Reads `<gravity>` [m/s^2], which was in `<physics>` up to SDF 1.5.
Vector3 readGravity(const Element& world, Context& context);

}  // namespace pongsim::sdf
