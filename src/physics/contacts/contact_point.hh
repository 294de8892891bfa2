#pragma once

class btManifoldPoint;
class btPersistentManifold;

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

/// Writes the surfaces' properties into a contact point: restitution, stiffness and damping with their flag, and for
/// directed friction the coefficient, directions and velocities. Clears the flag that says that the directions are set;
/// the caller that hands the point to Bullet sets it.
PointFriction settlePoint(btManifoldPoint& point, const btPersistentManifold& manifold);

}  // namespace pongsim::physics
