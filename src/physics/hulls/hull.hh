#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>
#include <span>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::physics {

/// A convex piece of a shape as Bullet takes it: corners that have drawn back by the margin [m], which Bullet adds
/// again and rounds the edges by.
struct Hull {
  std::vector<Vector3> corners;
  double margin = 0;
  bool operator==(const Hull&) const = default;
};

/// No hull has more corners: finding what touches it takes time with each of them.
inline constexpr std::size_t kMostCorners = 500;

/// @param points At least one. Of many, only the outermost are looked at.
Hull makeHull(const std::vector<Vector3>& points);

/// @param points Of a sheet without a thickness. They do not draw back: what is of no thickness gets twice the margin.
Hull makeSheet(const std::vector<Vector3>& points, double margin);

std::unique_ptr<btConvexHullShape> makeShape(const Hull& hull);

/// A convex hull and its size.
struct ConvexHull {
  /// Some of the points that it was made of.
  std::vector<Vector3> corners;
  /// [m^3], [m^2]
  double volume = 0;
  double area = 0;
};
ConvexHull convexHull(std::span<const Vector3> points);

/// @return The points that lie outermost in one of so many directions, which are spread evenly (a Fibonacci lattice).
std::vector<Vector3> outermost(std::span<const Vector3> points, std::size_t directions);

}  // namespace pongsim::physics
