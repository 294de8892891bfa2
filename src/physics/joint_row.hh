#pragma once

#include <LinearMath/btVector3.h>

#include <limits>

namespace pongsim::physics {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A row of a joint's velocity constraint, J v + compliance * impulse = bias, with bounds on its impulse: v are the
/// velocities of the joint's bodies at the end of the step, in the world frame. (E. Catto, Iterative dynamics with
/// temporal coherence, GDC 2005.)
struct JointRow {
  /// J of the child's linear velocity; the parent's is its negative.
  btVector3 linear;
  /// J of the angular velocities.
  btVector3 parentAngular;
  btVector3 childAngular;
  /// Only of a gearbox: that of the body which its axes are fixed to.
  btVector3 referenceAngular;
  /// [m/s] or [rad/s].
  double bias;
  /// Of the impulse [N s] or [N m s]; infinite for equations.
  double lowest;
  double highest;
  /// [m/s per N s] or [rad/s per N m s].
  double compliance = 0;
};

}  // namespace pongsim::physics
