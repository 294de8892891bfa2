#pragma once

class btManifoldPoint;
class btPersistentManifold;

namespace pongsim::physics {

/// What friction does at a point of contact that Bullet's point has no place for.
struct PointFriction {
  /// Whether it differs by direction, slips or runs along; else the three that follow mean nothing.
  bool isDirected = false;
  /// Coefficient across the first direction.
  double mu2 = 0;
  /// How fast the surfaces slip along the two directions by each newton of friction [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// Torque against turning about the normal, by each newton that presses there [m]; 0 for none.
  double torsion = 0;
  /// How fast it turns by each newton metre all the same [rad/s/(N m)].
  double torsionSlip = 0;
};

/// Writes into a point what the two surfaces say of it: restitution, stiffness and damping with their flag, and where
/// friction is directed its coefficient, directions and motions. The flag that says that the directions are there is
/// cleared, for who hands the point to Bullet to set.
PointFriction settlePoint(btManifoldPoint& point, const btPersistentManifold& manifold);

}  // namespace pongsim::physics
