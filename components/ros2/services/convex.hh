#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

#include "pongsim/geometry/shape.hh"
#include "pongsim/types.hh"

namespace pongsim::ros2 {

/// A convex body, given by its support function: its farthest point in each direction.
struct Convex {
  /// Any interior point.
  Vector3 center = Vector3::Zero();
  /// @param direction Not zero; need not be normalized.
  std::function<Vector3(const Vector3& direction)> farthest;
};

/// @return The shape of a collision placed at `X`; nothing for shapes that are not convex, infinite or empty
/// (triangles, planes, `NoShape`).
std::optional<Convex> convexOf(const Shape& shape, const Pose& X);

/// @return The convex hull of at least one point.
Convex convexHull(std::vector<Vector3> points);

/// @return Its axis-aligned bounding box.
Eigen::AlignedBox3d boxAround(const Convex& convex);

/// @return Whether they have a common point; either answer is possible for a gap or depth of some 1e-6 m.
bool overlap(const Convex& one, const Convex& other);

}  // namespace pongsim::ros2
