#pragma once

#include <LinearMath/btTransform.h>

namespace pongsim::physics {

/// @param axis Unit vector.
/// @return The rotation by `angle` [rad] about it, like Bullet's, but with the same bits on every machine.
btQuaternion turnAbout(const btVector3& axis, double angle);

/// @return A body's pose after `dt` [s] at these velocities [m/s], [rad/s], rotated by at most an eighth of a turn.
/// Without rotation, the orientation keeps its bits.
btTransform moved(const btTransform& now, const btVector3& linear, const btVector3& angular, double dt);

}  // namespace pongsim::physics
