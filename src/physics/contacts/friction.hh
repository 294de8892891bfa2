#pragma once

#include <LinearMath/btVector3.h>

#include <optional>

class btManifoldPoint;
class btPersistentManifold;

namespace pongsim::physics {

/// Friction that is not the same in all directions of a surface.
struct DirectedFriction {
  /// Coefficients along the first direction and across it.
  double mu = 0;
  double mu2 = 0;
  /// How fast the surfaces slip along these by each newton of friction [m/s/N].
  double slip1 = 0;
  double slip2 = 0;
  /// The first one, a unit vector of the world in the tangent plane.
  btVector3 direction;
  /// Velocity of the first body against the second one that friction draws them to, along the two directions [m/s]:
  /// what surfaces that run along ask for.
  double motion1 = 0;
  double motion2 = 0;
};

/// As Fortress's engine does: of two coefficients the smaller one, of two slips the sum; the first direction is `fdir1`
/// of the collision that has one, where both have that of the one with the smaller `mu2`, and where none has z of the
/// world, or x where that is the normal, each along the surface. Where a surface runs along, that is the first
/// direction.
/// @return Nothing where friction is the same in all directions and nothing slips or runs along.
std::optional<DirectedFriction> directedFriction(const btPersistentManifold& manifold, const btManifoldPoint& point);

/// How two surfaces act on each other at a point, beside friction along them. Fortress's engine has but the
/// restitution.
struct PointSurface {
  /// The product of the two.
  double restitution = 0;
  /// [m/s]: the smaller one of those that are given.
  double bounceThreshold = 0;
  /// Whether either is not rigid; [N/m] of both in series, [N s/m] of both together, of those that are not.
  bool isSoft = false;
  double stiffness = 0;
  double damping = 0;
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
