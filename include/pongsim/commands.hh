#pragma once

#include "pongsim/node.hh"

namespace pongsim {

/// What a number in a command may be, either way: in metres, radians or a second of them more than is ever meant, and
/// far below where the physics gives up (1e9).
inline constexpr double kLargestCommand = 1e6;

/// The same of a force [N] or a torque [N m]: three times what the largest rocket has.
inline constexpr double kLargestForce = 1e8;

/// For what a system is told to do: `node.subscribe<M>(topic, received, kCommands)`.
inline constexpr SubscriptionOptions kCommands{.largestNumber = kLargestCommand};

/// For forces and torques that a system is told to apply.
inline constexpr SubscriptionOptions kForces{.largestNumber = kLargestForce};

}  // namespace pongsim
