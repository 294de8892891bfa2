#pragma once

#include <LinearMath/btTransform.h>

namespace pongsim::physics {

/// @param axis Of length 1.
/// @return The rotation by `angle` [rad] about it, as Bullet makes it, but with the same bits on every machine.
btQuaternion turnAbout(const btVector3& axis, double angle);

/// @return Where a body is after `dt` [s] at these velocities [m/s], [rad/s]; turned by an eighth of a turn at most.
/// What does not turn keeps its rotation to the bit.
btTransform moved(const btTransform& now, const btVector3& linear, const btVector3& angular, double dt);

}  // namespace pongsim::physics
