#include "physics/gyroscope.hh"

#include <LinearMath/btQuaternion.h>

namespace pongsim::physics {

namespace {

// each takes the error down by about the angle of half a step; a wheel at 100 rad/s so ends below a billionth
constexpr int kIterations = 5;
// below this turn in a step [rad] there is nothing to do
constexpr double kSmallestTurn = 1e-8;

btMatrix3x3 turnedBy(const btVector3& turn, const btMatrix3x3& R) {
  return btMatrix3x3(btQuaternion(turn, turn.length())) * R;
}

btVector3 scaledInBody(const btMatrix3x3& R_WorldBody, const btVector3& factors, const btVector3& vector) {
  return R_WorldBody * (factors * (vector * R_WorldBody));
}

}  // namespace

btVector3 gyroscopicTorque(const btMatrix3x3& R_WorldBody, const btVector3& w_World, const btVector3& moments,
                           double dt) {
  if (w_World.length2() * dt * dt < kSmallestTurn * kSmallestTurn) return {0, 0, 0};
  const btVector3 momentum = scaledInBody(turnedBy(-dt / 2 * w_World, R_WorldBody), moments, w_World);
  const btVector3 inverse(1 / moments.x(), 1 / moments.y(), 1 / moments.z());
  btVector3 next = w_World;
  for (int i = 0; i < kIterations; ++i) {
    next = scaledInBody(turnedBy(dt / 2 * next, R_WorldBody), inverse, momentum);
  }
  return scaledInBody(R_WorldBody, moments, next - w_World) / dt;
}

}  // namespace pongsim::physics
