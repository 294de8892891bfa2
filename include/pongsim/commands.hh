#pragma once

#include "pongsim/node.hh"

namespace pongsim {

/// Largest magnitude of a number in a command [m, rad, or per second]: more than any reasonable command, and far below
/// the limits of the physics (1e9).
inline constexpr double kLargestCommand = 1e6;

/// Largest magnitude of a force [N] or torque [N m]: three times the thrust of the largest rocket.
inline constexpr double kLargestForce = 1e8;

/// Options for command topics: `node.subscribe<M>(topic, received, kCommands)`.
inline constexpr SubscriptionOptions kCommands{.largestNumber = kLargestCommand};

/// Options for topics with forces and torques.
inline constexpr SubscriptionOptions kForces{.largestNumber = kLargestForce};

}  // namespace pongsim
