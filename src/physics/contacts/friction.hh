#pragma once

#include <LinearMath/btVector3.h>

#include <optional>

class btManifoldPoint;
class btPersistentManifold;

namespace pongsim::physics {

/// Friction that depends on the direction along the surface.
struct DirectedFriction {
  /// Coefficients along the first direction and across it.
  double mu = 0;
  double mu2 = 0;
  /// Slip velocity along these per newton of friction [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// The first one, a unit vector of the world in the tangent plane.
  btVector3 direction;
  /// Velocity of the first body relative to the second that friction acts towards, along the two directions [m/s]; not
  /// zero for moving surfaces.
  double motion1 = 0;
  double motion2 = 0;
};

/// Combines the friction of two surfaces like Fortress's engine: the smaller coefficients and the sums of the slips.
/// The first direction is that of the moving surface, if any; else `fdir1` of the collision that has one, of two the
/// one with the smaller `mu2`; else the world's z, or x if z is the normal. It is projected onto the surface.
/// @return Nothing if friction is the same in all directions and nothing slips or moves.
std::optional<DirectedFriction> directedFriction(const btPersistentManifold& manifold, const btManifoldPoint& point);

/// How two surfaces act on each other at a point, beside friction along them. Fortress's engine has but the
/// restitution.
struct PointSurface {
  /// The product of the two.
  double restitution = 0;
  /// [m/s]: the smaller one of those that are given.
  double bounceThreshold = 0;
  /// Torque that friction has against turning about the normal, by each newton that presses there [m], and how fast it
  /// turns by each newton metre all the same [rad/s/(N m)].
  double torsion = 0;
  double torsionSlip = 0;
};

/// @return Nothing for bodies that are not ours.
std::optional<PointSurface> pointSurface(const btPersistentManifold& manifold, const btManifoldPoint& point);

/// @return At how many points the two may touch at once, where a collision says so; else `otherwise`.
long long mostContacts(const btPersistentManifold& manifold, long long otherwise);

}  // namespace pongsim::physics
