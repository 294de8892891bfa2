#include "ros2/services/bounds.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "pongsim/math.hh"
#include "ros2/services/result.hh"
#include "ros2/types/finite.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;

namespace {

/// Calls `seen(shape, X_WorldShape)` with each collision of the model and its nested models, until it returns true.
/// @return Whether it has returned true.
bool anyShape(const Model& model, const std::function<bool(const Shape&, const Pose&)>& seen) {
  for (const Link& link : model.links()) {
    for (const Collision& collision : link.collisions()) {
      if (seen(collision.shape(), link.pose() * collision.poseInLink())) return true;
    }
  }
  return std::ranges::any_of(model.models(), [&](const Model& each) { return anyShape(each, seen); });
}

std::array<Vector3, 3> corners(const TriangleShape& mesh, const std::array<std::uint32_t, 3>& triangle, const Pose& X) {
  std::array<Vector3, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = X * mesh.vertices[triangle[i]].cwiseProduct(mesh.scale);
  return points;
}

/// @return The winding number of the surface around the point: 1 inside a closed surface, 0 outside. The sum of the
/// solid angles of its triangles (A. Van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983).
double windingNumber(const TriangleShape& mesh, const Pose& X, const Vector3& point) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector3, 3> r = corners(mesh, triangle, X);
    for (Vector3& each : r) each -= point;
    const double a = r[0].norm(), b = r[1].norm(), c = r[2].norm();
    sum += 2 * math::atan2(r[0].dot(r[1].cross(r[2])),
                           a * b * c + r[0].dot(r[1]) * c + r[1].dot(r[2]) * a + r[2].dot(r[0]) * b);
  }
  return std::abs(sum) / (4 * std::numbers::pi);
}

geometry_msgs::Vector3 message(const Vector3& from) {
  geometry_msgs::Vector3 to;
  copyVector(from, to);
  return to;
}

/// @return Whether three of the points are not collinear.
bool spanPlane(const std::vector<Vector3>& points) {
  const Vector3 first = points.front();
  const Vector3 farthest =
      *std::ranges::max_element(points, {}, [&](const Vector3& each) { return (each - first).squaredNorm(); }) - first;
  return std::ranges::any_of(
      points, [&](const Vector3& each) { return farthest.cross(each - first).norm() > 1e-9 * farthest.squaredNorm(); });
}

}  // namespace

Outcome<si::Bounds> boundsOf(const Model& model) {
  const std::optional<Link> link = model.canonicalLink();
  const Pose X_FrameWorld = (link ? link->pose() : model.pose()).inverse();
  Eigen::AlignedBox3d box;
  const bool isEndless = anyShape(model, [&](const Shape& shape, const Pose& X_WorldShape) {
    const Pose X = X_FrameWorld * X_WorldShape;
    if (const auto convex = convexOf(shape, X)) box.extend(boxAround(*convex));
    if (const auto* mesh = std::get_if<TriangleShape>(&shape)) {
      for (const auto& triangle : mesh->triangles) {
        for (const Vector3& corner : corners(*mesh, triangle, X)) box.extend(corner);
      }
    }
    return std::holds_alternative<PlaneShape>(shape);
  });
  if (isEndless) return {si::Bounds(), {}};
  if (box.isEmpty()) return {{}, "'" + model.scopedName() + "' has no collision to compute its bounds from"};
  si::Bounds bounds;
  bounds.type = si::Bounds::kTypeBox;
  bounds.points = {message(box.max()), message(box.min())};
  return {bounds, {}};
}

Region::Region(Convex convex) : convex_(std::move(convex)), box_(boxAround(convex_)) {}

Outcome<Region> Region::from(const si::Bounds& bounds) {
  std::vector<Vector3> points;
  for (const auto& point : bounds.points) {
    if (!isFinite(point)) return {{}, "a point of the bounds is not finite"};
    points.push_back(vectorOf(point));
  }
  if (bounds.type == si::Bounds::kTypeConvexHull) {
    if (points.size() < 3) return {{}, "a convex hull needs at least 3 points"};
    if (!spanPlane(points)) return {{}, "the points of the convex hull lie on a line"};
    return {Region(convexHull(std::move(points))), {}};
  }
  if (points.size() != 2) {
    return {{},
            std::string("bounds that are a ") + (bounds.type == si::Bounds::kTypeBox ? "box" : "sphere") +
                " have two points, not " + std::to_string(points.size())};
  }
  if (bounds.type == si::Bounds::kTypeSphere) {
    const double radius = points[1].x();
    if (!(radius > 0)) return {{}, "the sphere's radius, x of the second point, is not above 0"};
    return {Region(convexOf(SphereShape{radius}, {points[0], Quaternion::Identity()}).value()), {}};
  }
  const Vector3 size = points[0] - points[1];
  if (!(size.minCoeff() >= 0)) return {{}, "the first point of the box must be its upper corner, the second its lower"};
  return {Region(convexOf(BoxShape{size}, {(points[0] + points[1]) / 2, Quaternion::Identity()}).value()), {}};
}

bool Region::overlaps(const Model& model) const {
  bool hasShape = false;
  const bool does = anyShape(model, [&](const Shape& shape, const Pose& X_WorldShape) {
    hasShape = hasShape || !std::holds_alternative<NoShape>(shape);
    return overlaps(shape, X_WorldShape);
  });
  return does || (!hasShape && overlap(convex_, convexHull({model.pose().position})));
}

bool Region::overlaps(const Shape& shape, const Pose& X_WorldShape) const {
  if (const auto* plane = std::get_if<PlaneShape>(&shape)) return overlaps(*plane, X_WorldShape);
  if (const auto* mesh = std::get_if<TriangleShape>(&shape)) return overlaps(*mesh, X_WorldShape);
  const std::optional<Convex> convex = convexOf(shape, X_WorldShape);
  return convex && box_.intersects(boxAround(*convex)) && overlap(convex_, *convex);
}

/// A plane includes everything below it.
bool Region::overlaps(const PlaneShape& plane, const Pose& X_WorldShape) const {
  const Vector3 normal = X_WorldShape.rotation * plane.normal;
  return normal.dot(convex_.farthest(-normal) - X_WorldShape.position) <= 0;
}

bool Region::overlaps(const TriangleShape& mesh, const Pose& X_WorldShape) const {
  for (const auto& triangle : mesh.triangles) {
    const std::array<Vector3, 3> points = corners(mesh, triangle, X_WorldShape);
    Eigen::AlignedBox3d box(points[0]);
    box.extend(points[1]).extend(points[2]);
    if (box_.intersects(box) && overlap(convex_, convexHull({points.begin(), points.end()}))) return true;
  }
  // no triangle crosses it, so it is entirely inside or outside
  return windingNumber(mesh, X_WorldShape, convex_.center) > 0.5;
}

}  // namespace pongsim::ros2
