#include "physics/motion.hh"

#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

constexpr double kMostTurn = std::numbers::pi / 4;
// below this [rad/s], the sine of half the angle of a step is the angle itself, for any step
constexpr double kSlow = 0.001;

}  // namespace

btQuaternion turnAbout(const btVector3& axis, double angle) {
  const auto [sine, cosine] = math::sinCos(angle / 2);
  return {axis.x() * sine, axis.y() * sine, axis.z() * sine, cosine};
}

// F. S. Grassia, Practical parameterization of rotations using the exponential map, Journal of Graphics Tools 3 (1998);
// as btTransformUtil::integrateTransform has it, which asks the C library for the sine
btTransform moved(const btTransform& now, const btVector3& linear, const btVector3& angular, double dt) {
  btTransform then(now.getBasis(), now.getOrigin() + linear * dt);
  // converting to a quaternion and back would change a bit of the matrix
  if (angular.isZero()) return then;
  const double square = angular.length2();
  double speed = square > SIMD_EPSILON ? btSqrt(square) : 0;
  if (speed * dt > kMostTurn) speed = kMostTurn / dt;
  const auto [sine, cosine] = math::sinCos(0.5 * speed * dt);
  const btVector3 half = angular * (speed < kSlow ? 0.5 * dt : sine / speed);
  btQuaternion rotation = btQuaternion(half.x(), half.y(), half.z(), cosine) * now.getRotation();
  rotation.safeNormalize();
  if (rotation.length2() > SIMD_EPSILON) then.setRotation(rotation);
  return then;
}

}  // namespace pongsim::physics
