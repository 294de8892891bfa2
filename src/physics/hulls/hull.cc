#include "physics/hulls/hull.hh"

#include <LinearMath/btConvexHullComputer.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>

#include "physics/convert.hh"
#include "physics/shapes/margin.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

/// The time to build a hull grows with its points: of more, only the outermost in this many directions are used.
constexpr std::size_t kMostPoints = 5000;
constexpr std::size_t kDirections = 2000;

/// @param margin How far the faces are moved inwards; less if there is no room.
std::vector<Vector3> cornersOf(const std::vector<Vector3>& points, double margin) {
  btConvexHullComputer computer;
  computer.compute(points[0].data(), sizeof(Vector3), static_cast<int>(points.size()), margin, 1);
  std::vector<Vector3> corners;
  for (int i = 0; i < computer.vertices.size(); ++i) corners.push_back(fromBullet(computer.vertices[i]));
  return corners;
}

Hull drawBack(std::vector<Vector3> points, double drawnBack, double margin) {
  if (points.size() > kMostPoints) points = outermost(points, kDirections);
  Hull hull{cornersOf(points, drawnBack), margin};
  if (hull.corners.size() > kMostCorners) hull.corners = outermost(hull.corners, kMostCorners);
  return hull;
}

}  // namespace

std::vector<Vector3> outermost(std::span<const Vector3> points, std::size_t directions) {
  std::set<std::size_t> kept;
  for (std::size_t i = 0; i < directions; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(directions);
    const double radius = std::sqrt(1 - z * z);
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5));
    const Vector3 direction(radius * math::cos(angle), radius * math::sin(angle), z);
    const auto along = [&](const Vector3& p) {
      return direction.x() * p.x() + direction.y() * p.y() + direction.z() * p.z();
    };
    std::size_t best = 0;
    double farthest = along(points[0]);
    for (std::size_t k = 1; k < points.size(); ++k) {
      const double distance = along(points[k]);
      if (distance <= farthest) continue;
      farthest = distance;
      best = k;
    }
    kept.insert(best);
  }
  std::vector<Vector3> outer;
  for (const std::size_t index : kept) outer.push_back(points[index]);
  return outer;
}

Hull makeHull(const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) box.extend(point);
  // Bullet adds the margin to a hull, so the faces are moved in by as much first
  const double margin = marginFor(box.sizes().minCoeff() / 2);
  return drawBack(points, margin, margin);
}

Hull makeSheet(const std::vector<Vector3>& points, double margin) { return drawBack(points, 0, margin); }

std::unique_ptr<btConvexHullShape> makeShape(const Hull& hull) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vector3& corner : hull.corners) shape->addPoint(toBullet(corner), false);
  shape->setMargin(hull.margin);
  shape->recalcLocalAabb();
  return shape;
}

ConvexHull convexHull(std::span<const Vector3> points) {
  ConvexHull hull;
  if (points.empty()) return hull;
  btConvexHullComputer computer;
  computer.compute(points[0].data(), sizeof(Vector3), static_cast<int>(points.size()), 0, 0);
  const int count = computer.vertices.size();
  // undo rounding: these are the original points
  for (int i = 0; i < count; ++i) {
    hull.corners.push_back(points[static_cast<std::size_t>(computer.original_vertex_index[i])]);
  }
  const auto corner = [&](int index) { return hull.corners[static_cast<std::size_t>(index)] - hull.corners[0]; };
  for (int i = 0; i < computer.faces.size(); ++i) {
    const btConvexHullComputer::Edge* const first = &computer.edges[computer.faces[i]];
    const Vector3 a = corner(first->getSourceVertex());
    Vector3 normal = Vector3::Zero();
    for (const auto* edge = first->getNextEdgeOfFace(); edge != first; edge = edge->getNextEdgeOfFace()) {
      const Vector3 b = corner(edge->getSourceVertex());
      const Vector3 c = corner(edge->getTargetVertex());
      const Vector3 twice = (b - a).cross(c - a);
      hull.volume += a.dot(twice) / 6;
      normal += twice;
    }
    hull.area += normal.norm() / 2;
  }
  hull.volume = std::abs(hull.volume);
  return hull;
}

}  // namespace pongsim::physics
