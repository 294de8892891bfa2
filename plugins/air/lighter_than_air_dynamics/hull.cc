#include "hull.hh"

#include "pongsim/math.hh"

namespace pongsim {

Wrench hullWrench(const HullSettings& hull, const Vector3& velocity, const Vector3& rates) {
  // where the flow separates
  const Vector3 local = velocity + rates.cross(Vector3(-hull.separation, 0, 0));
  const double across = math::hypot(local.y(), local.z());
  const double pressure = hull.density / 2 * local.squaredNorm();
  const double angle = math::atan2(across, local.x());
  const double doubled = math::sin(2 * angle);
  const double squared = math::sin(angle) * math::sin(angle);
  const double force = pressure * (hull.viscousForce * squared - hull.inviscidForce * doubled);
  const double moment = pressure * (hull.viscousMoment * squared - hull.inviscidMoment * doubled);

  Wrench wrench;
  if (across > 0) {
    const double y = local.y() / across, z = local.z() / across;
    wrench.force = force * Vector3(0, -y, -z);
    wrench.torque = moment * Vector3(0, z, -y);
  }
  const double cosine = math::cos(math::atan2(velocity.z(), velocity.x()));
  wrench.force.x() -= hull.density / 2 * velocity.squaredNorm() * hull.axialDrag * cosine * cosine;
  return wrench;
}

}  // namespace pongsim
