#include "sensing/shape.hh"

#include <algorithm>
#include <cmath>

namespace pongsim::sensing {

namespace {

/// Intersects a passage with another one.
/// @return Whether anything is left.
bool narrow(Passage& passage, const Passage& other) {
  passage.enter = std::max(passage.enter, other.enter);
  passage.leave = std::min(passage.leave, other.leave);
  return passage.enter <= passage.leave;
}

/// Between two parallel planes, at -half and half.
std::optional<Passage> slabPassage(double half, double origin, double direction) {
  if (direction == 0) {
    if (std::abs(origin) > half) return std::nullopt;
    return Passage{-kNowhere, kNowhere};
  }
  const double a = (-half - origin) / direction, b = (half - origin) / direction;
  return Passage{std::min(a, b), std::max(a, b)};
}

/// Within a ball, or a disc, around zero. Solved around the line's point nearest to the centre instead of its origin,
/// which avoids cancellation when the origin is far away.
template <class Vector>
std::optional<Passage> ballPassage(double radius, const Vector& origin, const Vector& direction) {
  const double squaredLength = direction.squaredNorm();
  if (squaredLength == 0) {
    if (origin.squaredNorm() > radius * radius) return std::nullopt;
    return Passage{-kNowhere, kNowhere};
  }
  const double middle = -origin.dot(direction) / squaredLength;
  const double rest = radius * radius - (origin + middle * direction).squaredNorm();
  if (rest < 0) return std::nullopt;
  const double half = std::sqrt(rest / squaredLength);
  return Passage{middle - half, middle + half};
}

std::optional<Passage> tubePassage(double radius, double length, const Line& line) {
  const Eigen::Vector2d origin = line.origin.head<2>(), direction = line.direction.head<2>();
  std::optional<Passage> found = ballPassage(radius, origin, direction);
  const auto between = slabPassage(length / 2, line.origin.z(), line.direction.z());
  if (!found || !between || !narrow(*found, *between)) return std::nullopt;
  return found;
}

/// Of a double cone with its tip at zero and the given slope of its radius along z: the half on the side of -z.
/// @param origin Where the line begins, near the cone.
std::optional<Passage> conePassage(double slope, const Vector3& origin, const Vector3& direction) {
  // x^2 + y^2 <= (slope z)^2, in the line's parameter t: a t^2 + 2 b t + c <= 0
  const auto product = [slope](const Vector3& u, const Vector3& v) {
    return u.x() * v.x() + u.y() * v.y() - slope * slope * u.z() * v.z();
  };
  const double a = product(direction, direction), b = product(origin, direction), c = product(origin, origin);
  const double rest = b * b - a * c;
  // a steep line always meets the double cone, whatever rounding says of one through the tip
  if (rest < 0 && !(a < 0)) return std::nullopt;
  // without cancellation; one root is infinite where the line is parallel to the side
  const double sum = -(b + std::copysign(std::sqrt(std::max(rest, 0.0)), b));
  if (sum == 0 && a == 0) return std::nullopt;
  const double first = sum / a, second = sum != 0 ? c / sum : first;
  const auto [lower, upper] = std::minmax(first, second);
  if (a > 0) return Passage{lower, upper};
  // a steep line passes through both halves: below the tip before or after it is in the other one
  const double finite = a < 0 ? (direction.z() > 0 ? lower : upper) : second;
  return direction.z() > 0 ? Passage{-kNowhere, finite} : Passage{finite, kNowhere};
}

struct FindPassage {
  const Line& line;

  std::optional<Passage> operator()(const description::Box& box) const { return boxPassage(box.size / 2, line); }

  std::optional<Passage> operator()(const description::Sphere& sphere) const {
    return ballPassage(sphere.radius, line.origin, line.direction);
  }

  std::optional<Passage> operator()(const description::Cylinder& cylinder) const {
    return tubePassage(cylinder.radius, cylinder.length, line);
  }

  // a capsule is convex: the line's passages through tube and caps join to one
  std::optional<Passage> operator()(const description::Capsule& capsule) const {
    std::optional<Passage> found = tubePassage(capsule.radius, capsule.length, line);
    for (const double end : {-capsule.length / 2, capsule.length / 2}) {
      const Vector3 origin = line.origin - Vector3(0, 0, end);
      const auto cap = ballPassage(capsule.radius, origin, line.direction);
      if (!cap) continue;
      found = found ? Passage{std::min(found->enter, cap->enter), std::max(found->leave, cap->leave)} : *cap;
    }
    return found;
  }

  std::optional<Passage> operator()(const description::Cone& cone) const {
    // begins at the point nearest to the middle, which avoids cancellation when the origin is far away
    const double nearest = -line.origin.dot(line.direction) / line.direction.squaredNorm();
    const Vector3 origin = line.origin + nearest * line.direction;
    const Vector3 fromTip = origin - Vector3(0, 0, cone.length / 2);
    std::optional<Passage> found = conePassage(cone.radius / cone.length, fromTip, line.direction);
    const auto between = slabPassage(cone.length / 2, origin.z(), line.direction.z());
    if (!found || !between || !narrow(*found, *between)) return std::nullopt;
    return Passage{nearest + found->enter, nearest + found->leave};
  }

  std::optional<Passage> operator()(const description::Ellipsoid& ellipsoid) const {
    const Vector3 origin = line.origin.cwiseQuotient(ellipsoid.radii);
    const Vector3 direction = line.direction.cwiseQuotient(ellipsoid.radii);
    return ballPassage(1, origin, direction);
  }

  std::optional<Passage> operator()(const Sheet& sheet) const {
    if (line.direction.z() == 0) return std::nullopt;
    const double t = -line.origin.z() / line.direction.z();
    const Vector3 point = line.origin + t * line.direction;
    if (std::abs(point.x()) > sheet.half.x() || std::abs(point.y()) > sheet.half.y()) return std::nullopt;
    return line.direction.z() < 0 ? Passage{t, kNowhere} : Passage{-kNowhere, t};
  }
};

struct FindHalfSize {
  Vector3 operator()(const description::Box& box) const { return box.size / 2; }
  Vector3 operator()(const description::Sphere& sphere) const { return Vector3::Constant(sphere.radius); }
  Vector3 operator()(const description::Cylinder& cylinder) const {
    return {cylinder.radius, cylinder.radius, cylinder.length / 2};
  }
  Vector3 operator()(const description::Capsule& capsule) const {
    return {capsule.radius, capsule.radius, capsule.length / 2 + capsule.radius};
  }
  Vector3 operator()(const description::Cone& cone) const { return {cone.radius, cone.radius, cone.length / 2}; }
  Vector3 operator()(const description::Ellipsoid& ellipsoid) const { return ellipsoid.radii; }
  Vector3 operator()(const Sheet& sheet) const { return {sheet.half.x(), sheet.half.y(), 0}; }
};

}  // namespace

std::optional<Passage> boxPassage(const Vector3& half, const Line& line) {
  Passage found{-kNowhere, kNowhere};
  for (int axis = 0; axis < 3; ++axis) {
    const auto slab = slabPassage(half[axis], line.origin[axis], line.direction[axis]);
    if (!slab || !narrow(found, *slab)) return std::nullopt;
  }
  return found;
}

std::optional<Passage> passage(const Shape& shape, const Line& line) { return std::visit(FindPassage{line}, shape); }

Eigen::AlignedBox3d boundsOf(const Shape& shape) {
  const Vector3 half = std::visit(FindHalfSize(), shape);
  return {-half, half};
}

double firstSeen(const Passage& passage, double from, bool seesInside) {
  if (passage.enter >= from) return passage.enter;
  if (seesInside && passage.leave >= from) return passage.leave;
  return kNowhere;
}

}  // namespace pongsim::sensing
