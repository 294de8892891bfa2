#include "pongsim/geometry/rotation_between.hh"

#include <cmath>

namespace pongsim {

namespace {

/// Of nearly opposite unit vectors. Their sum and difference are twice the half angle's cosine and sine.
Quaternion nearlyHalfATurn(const Vector3& from, const Vector3& to) {
  const Vector3 sum = from + to, difference = from - to;
  const Vector3 across = difference.cross(sum);
  const double length = across.norm();
  const Vector3 axis = length > 1e-14 ? Vector3(across / length) : difference.unitOrthogonal();
  const Vector3 vector = axis * (difference.norm() / 2);
  return {sum.norm() / 2, vector.x(), vector.y(), vector.z()};
}

}  // namespace

// Not Eigen's FromTwoVectors: for opposite directions that takes a singular value decomposition, 30 kB of code that
// takes 5 s to compile, and it loses half of the digits near them.
Quaternion rotationBetween(const Vector3& from, const Vector3& to) {
  const Vector3 start = from.normalized(), end = to.normalized();
  const double cosine = start.dot(end);
  if (cosine < -0.99) return nearlyHalfATurn(start, end);
  const double scale = std::sqrt((1 + cosine) * 2);
  const Vector3 vector = start.cross(end) / scale;
  return {scale / 2, vector.x(), vector.y(), vector.z()};
}

}  // namespace pongsim
