#include "ros2/services/convex.hh"

#include <ccd/ccd.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace pongsim::ros2 {

namespace {

/// Makes a `Convex` from a shape's parameters in its own frame.
Convex placed(const Pose& X, std::function<Vector3(const Vector3&)> farthest) {
  return {X.position, [X, farthest = std::move(farthest)](const Vector3& direction) {
            return X * farthest(X.rotation.conjugate() * direction);
          }};
}

Vector3 signs(const Vector3& direction) {
  return direction.unaryExpr([](double each) { return each < 0 ? -1.0 : 1.0; });
}

Vector3 onBall(const Vector3& direction, double radius) { return radius * direction.stableNormalized(); }

struct ConvexOf {
  Pose X;

  std::optional<Convex> operator()(const BoxShape& box) const {
    return placed(X,
                  [half = Vector3(box.size / 2)](const Vector3& d) -> Vector3 { return half.cwiseProduct(signs(d)); });
  }
  std::optional<Convex> operator()(const SphereShape& sphere) const {
    return placed(X, [r = sphere.radius](const Vector3& d) { return onBall(d, r); });
  }
  std::optional<Convex> operator()(const CylinderShape& cylinder) const {
    return placed(X, [r = cylinder.radius, half = cylinder.length / 2](const Vector3& d) -> Vector3 {
      return onBall({d.x(), d.y(), 0}, r) + Vector3(0, 0, d.z() < 0 ? -half : half);
    });
  }
  std::optional<Convex> operator()(const CapsuleShape& capsule) const {
    return placed(X, [r = capsule.radius, half = capsule.length / 2](const Vector3& d) -> Vector3 {
      return onBall(d, r) + Vector3(0, 0, d.z() < 0 ? -half : half);
    });
  }
  std::optional<Convex> operator()(const EllipsoidShape& ellipsoid) const {
    // the image of a ball under the scaling S: its farthest point along d is S (S d) / |S d|
    return placed(X, [radii = ellipsoid.radii](const Vector3& d) -> Vector3 {
      return radii.cwiseProduct(onBall(radii.cwiseProduct(d), 1));
    });
  }
  std::optional<Convex> operator()(const NoShape&) const { return std::nullopt; }
  std::optional<Convex> operator()(const PlaneShape&) const { return std::nullopt; }
  std::optional<Convex> operator()(const TriangleShape&) const { return std::nullopt; }
};

// Callbacks of libccd.

void supportOf(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Vector3 d(direction->v[0], direction->v[1], direction->v[2]);
  // libccd never asks for the zero vector, but rounding may produce it
  const Vector3 found = static_cast<const Convex*>(object)->farthest(d.isZero(0) ? Vector3(Vector3::UnitX()) : d);
  ccdVec3Set(point, found.x(), found.y(), found.z());
}

}  // namespace

std::optional<Convex> convexOf(const Shape& shape, const Pose& X) { return std::visit(ConvexOf{X}, shape); }

Convex convexHull(std::vector<Vector3> points) {
  Vector3 center = Vector3::Zero();
  for (const Vector3& point : points) center += point / static_cast<double>(points.size());
  return {center, [points = std::move(points)](const Vector3& direction) {
            return *std::ranges::max_element(points, {}, [&](const Vector3& point) { return point.dot(direction); });
          }};
}

Eigen::AlignedBox3d boxAround(const Convex& convex) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 direction = Vector3::Unit(axis);
    box.min()[axis] = convex.farthest(-direction)[axis];
    box.max()[axis] = convex.farthest(direction)[axis];
  }
  return box;
}

bool overlap(const Convex& one, const Convex& other) {
  constexpr unsigned long kMostIterations = 500;
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = supportOf;
  ccd.support2 = supportOf;
  ccd.max_iterations = kMostIterations;
  return ccdGJKIntersect(&one, &other, &ccd) != 0;
}

}  // namespace pongsim::ros2
