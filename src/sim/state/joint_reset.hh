#pragma once

#include <cstddef>
#include <string>

#include "sim/api/access.hh"

namespace pongsim::sim {

// Functions that reset joints between two steps. A refused change has no effect.

/// Moves everything connected to the joint's child so that the axis has that position; velocities rotate along.
/// @param joint With such an axis.
Outcome<void> resetJointPosition(Access& access, world::Slot joint, std::size_t axis, double position);

/// Gives everything connected to the joint's child the velocity at which the axis moves with `velocity`.
Outcome<void> resetJointVelocity(Access& access, world::Slot joint, std::size_t axis, double velocity);

}  // namespace pongsim::sim
