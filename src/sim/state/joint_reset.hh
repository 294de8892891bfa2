#pragma once

#include <cstddef>
#include <string>

#include "sim/api/access.hh"

namespace pongsim::sim {

// Functions that reset joints between two steps. A refused change has no effect.

/// Moves everything connected to the joint's child so that the axis gets this position [m, rad]; velocities are rotated
/// with it.
/// @param joint Must have such an axis.
Outcome<void> resetJointPosition(Access& access, world::Slot joint, std::size_t axis, double position);

/// Sets the velocities of everything connected to the joint's child so that the axis moves at `velocity` [m/s, rad/s].
Outcome<void> resetJointVelocity(Access& access, world::Slot joint, std::size_t axis, double velocity);

}  // namespace pongsim::sim
