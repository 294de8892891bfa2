#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "ros2/services/convex.hh"
#include "ros2/types/simulation_interfaces.hh"

namespace pongsim::ros2 {

/// @return The smallest box around all collisions of the model and of those nested in it, along the axes of its
/// canonical link and in that frame, as simulation_interfaces has it; empty where it has a plane, which has no end.
/// An error where it has no collision.
Outcome<simulation_interfaces::Bounds> boundsOf(const Model& model);

/// A part of the world that a filter names.
class Region {
 public:
  /// @param bounds In the world frame. Not empty.
  /// @return The region, or what is wrong with the bounds.
  static Outcome<Region> from(const simulation_interfaces::Bounds& bounds);

  /// @return Whether a collision of the model, or of one nested in it, has a point in common with it; of a mesh, its
  /// surface and what that encloses. Of a model without collisions the origin counts.
  bool overlaps(const Model& model) const;

 private:
  explicit Region(Convex convex);
  bool overlaps(const Shape& shape, const Pose& X_WorldShape) const;
  bool overlaps(const PlaneShape& plane, const Pose& X_WorldShape) const;
  bool overlaps(const TriangleShape& mesh, const Pose& X_WorldShape) const;

  Convex convex_;
  Eigen::AlignedBox3d box_;
};

}  // namespace pongsim::ros2
