#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

#include "pongsim/geometry/shape.hh"
#include "pongsim/types.hh"

namespace pongsim::ros2 {

/// A convex part of space, told by its farthest point in each direction.
struct Convex {
  /// Any point within.
  Vector3 center = Vector3::Zero();
  /// @param direction Not zero; of any length.
  std::function<Vector3(const Vector3& direction)> farthest;
};

/// @return A shape of a collision, in the frame in which `X` places it; nothing for those that are not convex, have no
/// end or are nothing (triangles, planes, `NoShape`).
std::optional<Convex> convexOf(const Shape& shape, const Pose& X);

/// @return The convex hull of points, of which there is at least one.
Convex convexHull(std::vector<Vector3> points);

/// @return The smallest box around it along the axes.
Eigen::AlignedBox3d boxAround(const Convex& convex);

/// @return Whether both have a point in common; what touches within some 1e-6 m may be either.
bool overlap(const Convex& one, const Convex& other);

}  // namespace pongsim::ros2
