#include "physics/gyroscope.hh"

#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

// each multiplies the error by about the angle of half a step: for a wheel at 100 rad/s it ends below 1e-9
constexpr int kMostIterations = 5;
// a smaller relative change is rounding
constexpr double kEnough = 1e-15;
// below this rotation per step [rad] the torque is negligible
constexpr double kSmallestSpin = 1e-8;

struct Turn {
  explicit Turn(const btVector3& vector) : axis(0, 0, 0), sine(0), cosine(1) {
    const double angle = vector.length();
    if (angle == 0) return;
    axis = vector / angle;
    const math::SineAndCosine both = math::sinCos(angle);
    sine = both.sine;
    cosine = both.cosine;
  }

  // Rodrigues' formula
  btVector3 operator()(const btVector3& vector) const { return turned(vector, sine); }
  btVector3 back(const btVector3& vector) const { return turned(vector, -sine); }
  btMatrix3x3 matrix() const {
    const btVector3 s = sine * axis, a = (1 - cosine) * axis;
    return {cosine + a.x() * axis.x(), a.y() * axis.x() - s.z(),  a.z() * axis.x() + s.y(),
            a.x() * axis.y() + s.z(),  cosine + a.y() * axis.y(), a.z() * axis.y() - s.x(),
            a.x() * axis.z() - s.y(),  a.y() * axis.z() + s.x(),  cosine + a.z() * axis.z()};
  }

  btVector3 axis;
  double sine;
  double cosine;

 private:
  [[gnu::always_inline]] btVector3 turned(const btVector3& vector, double s) const {
    return cosine * vector + s * axis.cross(vector) + (1 - cosine) * axis.dot(vector) * axis;
  }
};

}  // namespace

std::optional<Gyration> gyration(const btMatrix3x3& R_WorldBody, const btVector3& w_World, const btVector3& moments,
                                 double dt, bool isHeld) {
  if (w_World.length2() * dt * dt < kSmallestSpin * kSmallestSpin) return std::nullopt;
  if (moments.x() == moments.y() && moments.y() == moments.z()) return std::nullopt;
  // all of it in the body's frame
  const btVector3 before = w_World * R_WorldBody;
  Turn half(dt / 2 * before);
  const btVector3 momentum = half.back(moments * before);
  const btVector3 inverse(1 / moments.x(), 1 / moments.y(), 1 / moments.z());
  btVector3 next = before;
  // fixed-point iteration for a free body; the next velocity of a held one depends on its joints, so the last is taken
  for (int i = 0; i < (isHeld ? 0 : kMostIterations); ++i) {
    const btVector3 last = next;
    next = half(inverse * half.back(momentum));
    half = Turn(dt / 2 * next);
    if ((next - last).length2() <= kEnough * kEnough * next.length2()) break;
  }
  const btVector3 torque = R_WorldBody * (momentum - half(moments * half.back(before))) / dt;
  return Gyration{torque, R_WorldBody * half.matrix()};
}

}  // namespace pongsim::physics
