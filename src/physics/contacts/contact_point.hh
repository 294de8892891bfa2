#pragma once

#include <LinearMath/btVector3.h>

class btManifoldPoint;
class btPersistentManifold;
class btRigidBody;

namespace pongsim::physics {

/// Friction at a contact point, as far as Bullet's point has no field for it.
struct PointFriction {
  /// Whether friction depends on the direction, slips, or has a surface velocity; if not, ignore the next three values.
  bool isDirected = false;
  /// Coefficient along the second friction direction.
  double mu2 = 0;
  /// Slip velocity along the two directions per newton of friction [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// Torque against spinning about the normal, per newton of normal force [m]; 0: none.
  double torsion = 0;
  /// Spin velocity that remains, per newton metre [rad/s/(N m)].
  double torsionSlip = 0;
};

/// Writes the surfaces' properties into a contact point: restitution, and for directed friction the coefficient,
/// directions and velocities.
PointFriction settlePoint(btManifoldPoint& point, const btPersistentManifold& manifold);

/// A contact point as the solvers need it.
struct SolverContact {
  /// Settles the point.
  SolverContact(btManifoldPoint& point, const btPersistentManifold& manifold);

  /// Sets both friction directions of a point without directed friction: along the sliding, if there is any.
  /// @param velocity Of the first body relative to the second, at the point.
  void chooseDirections(const btVector3& velocity) const;

  btManifoldPoint& point;
  const btRigidBody& a;
  const btRigidBody& b;
  /// From the bodies' centres of mass to the point.
  btVector3 armA;
  btVector3 armB;
  PointFriction friction;
};

}  // namespace pongsim::physics
