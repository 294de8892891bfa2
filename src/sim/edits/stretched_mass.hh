#pragma once

#include "description/link.hh"
#include "pongsim/outcome.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// @param before The shape of the link's only collision.
/// @param after That collision with another size.
/// @return The mass and inertia of the link if its mass, with the density that it has at each place, is stretched as
/// the shape is. Refused where this would move the centre of mass or turn the principal axes of inertia, which stay.
Outcome<physics::Engine::Mass> stretchedMass(const Access& access, world::Slot link,
                                             const description::Geometry& before, const description::Collision& after);

}  // namespace pongsim::sim
