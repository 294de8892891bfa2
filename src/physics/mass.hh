#pragma once

#include "description/link.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// Mass properties of a link in Bullet's body frame: at the centre of mass, along the principal axes.
struct PrincipalMass {
  /// [kg]
  double mass = 0;
  /// Principal moments of inertia [kg m^2].
  Vector3 moments = Vector3::Zero();
  /// Pose of the body frame in the link frame.
  Pose X_LinkBody;
};

/// @throws std::invalid_argument if mass or a principal moment is not a positive, finite number.
PrincipalMass principalMass(const description::Inertial& inertial);

}  // namespace pongsim::physics
