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
};

/// As Fortress's engine does: of two coefficients the smaller one, of two slips the sum; the first direction is `fdir1`
/// of the collision that has one, where both have that of the one with the smaller `mu2`, and where none has z of the
/// world, or x where that is the normal, each along the surface.
/// @return Nothing where friction is the same in all directions and nothing slips.
std::optional<DirectedFriction> directedFriction(const btPersistentManifold& manifold, const btManifoldPoint& point);

}  // namespace pongsim::physics
