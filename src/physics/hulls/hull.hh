#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>
#include <span>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::physics {

/// A convex piece of a shape in Bullet's form: its corners are moved in by the margin [m], which Bullet adds again,
/// rounding the edges.
struct Hull {
  std::vector<Vector3> corners;
  double margin = 0;
  bool operator==(const Hull&) const = default;
};

/// Maximum number of corners of a hull: contact detection takes time for each of them.
inline constexpr std::size_t kMostCorners = 500;

/// @param points At least one. If there are many, only the outermost are used.
Hull makeHull(const std::vector<Vector3>& points);

/// @param points Of a sheet without thickness. They are not moved in: the sheet becomes two margins thick.
Hull makeSheet(const std::vector<Vector3>& points, double margin);

std::unique_ptr<btConvexHullShape> makeShape(const Hull& hull);

/// A convex hull and its size.
struct ConvexHull {
  /// A subset of the points it was made of.
  std::vector<Vector3> corners;
  /// [m^3], [m^2]
  double volume = 0;
  double area = 0;
};
ConvexHull convexHull(std::span<const Vector3> points);

/// @return The points that lie outermost in one of this many evenly spread directions (a Fibonacci lattice).
std::vector<Vector3> outermost(std::span<const Vector3> points, std::size_t directions);

}  // namespace pongsim::physics
