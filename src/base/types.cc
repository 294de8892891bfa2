#include "pongsim/types.hh"

#include <algorithm>

#include "pongsim/math.hh"

namespace pongsim {

Quaternion rotationAbout(const Vector3& axis, double angle) {
  const auto [sine, cosine] = math::sinCos(angle / 2);
  return {cosine, sine * axis.x(), sine * axis.y(), sine * axis.z()};
}

Quaternion fromRollPitchYaw(double roll, double pitch, double yaw) {
  return rotationAbout(Vector3::UnitZ(), yaw) * rotationAbout(Vector3::UnitY(), pitch) *
         rotationAbout(Vector3::UnitX(), roll);
}

double yawOf(const Quaternion& rotation) {
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  return math::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

Vector3 rollPitchYawOf(const Quaternion& rotation) {
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  return {math::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
          math::asin(std::min(std::max(2 * (w * y - z * x), -1.0), 1.0)), yawOf(rotation)};
}

}  // namespace pongsim
