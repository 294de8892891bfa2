#pragma once

#include <optional>

#include "description/geometry.hh"
#include "description/link.hh"

namespace pongsim::sdf {

/// The mass of a homogeneous body and its distribution.
struct MassProperties {
  /// [kg]
  double mass = 0;
  /// Mass times centre of mass [kg m].
  Vector3 first = Vector3::Zero();
  /// Inertia tensor about the origin, not the centre of mass [kg m^2].
  Matrix3 moments = Matrix3::Zero();

  MassProperties& operator+=(const MassProperties& other);
  /// @return Those of the same body in frame A.
  MassProperties in(const Pose& X_AB) const;
  /// @return The inertia about the centre of mass, scaled to a mass.
  description::Inertial inertial(double scaledMass) const;
};

/// @param density [kg/m^3]
/// @return In the frame of the shape; nothing for shapes without a volume: planes, heightmaps, images, and meshes that
/// can't be read. An open mesh counts as the cone from the mean of its vertices to its surface.
std::optional<MassProperties> massPropertiesOf(const description::Geometry& geometry, double density);

}  // namespace pongsim::sdf
