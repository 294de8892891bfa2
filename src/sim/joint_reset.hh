#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "sim/access.hh"

namespace pongsim::sim {

// Between two steps; what is refused changes nothing.

/// Puts all that hangs on the joint's child where the axis has that position; velocities turn with it.
/// @param joint With such an axis.
/// @return Why not, or nothing.
std::optional<std::string> resetJointPosition(Access& access, world::Slot joint, std::size_t axis, double position);

/// Gives all that hangs on the joint's child the velocity with which the axis moves at `velocity`.
std::optional<std::string> resetJointVelocity(Access& access, world::Slot joint, std::size_t axis, double velocity);

}  // namespace pongsim::sim
