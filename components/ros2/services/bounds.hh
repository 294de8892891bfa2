#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "ros2/services/convex.hh"
#include "ros2/types/simulation_interfaces.hh"

namespace pongsim::ros2 {

/// @return The bounding box of all collisions of the model and its nested models, in the frame of its canonical link,
/// as defined by simulation_interfaces; empty if it has a plane, which is infinite. An error if it has no collision.
Outcome<simulation_interfaces::Bounds> boundsOf(const Model& model);

/// The part of the world that a filter selects.
class Region {
 public:
  /// @param bounds In the world frame. Not empty.
  /// @return The region, or what is wrong with the bounds.
  static Outcome<Region> from(const simulation_interfaces::Bounds& bounds);

  /// @return Whether a collision of the model or of a nested one has a common point with it; meshes count with their
  /// surface and inside. A model without collisions counts with its origin.
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
