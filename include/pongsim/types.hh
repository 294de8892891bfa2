#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <compare>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "pongsim/math.hh"

namespace pongsim {

/// Simulated time since the start of the run, or a duration.
using Time = std::chrono::nanoseconds;

/// @return `time` in seconds.
constexpr double toSeconds(Time time) { return std::chrono::duration<double>(time).count(); }

/// @return `seconds` [s] rounded to the nearest nanosecond. The argument must be finite and below 2^63 ns.
constexpr Time fromSeconds(double seconds) {
  const double nanoseconds = seconds * 1e9;
  return Time(static_cast<Time::rep>(nanoseconds + (nanoseconds < 0 ? -0.5 : 0.5)));
}

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// A rigid transform. Variables name both frames: `X_AB` is the pose of frame B in frame A, so that `p_A = X_AB * p_B`
/// and `X_AC = X_AB * X_BC`. Position in metres, rotation a unit quaternion.
struct Pose {
  Vector3 position = Vector3::Zero();
  Quaternion rotation = Quaternion::Identity();

  Pose operator*(const Pose& other) const {
    return {position + rotation * other.position, (rotation * other.rotation).normalized()};
  }
  Vector3 operator*(const Vector3& point) const { return position + rotation * point; }
  Pose inverse() const {
    const Quaternion inverted = rotation.conjugate();
    return {-(inverted * position), inverted};
  }
  bool operator==(const Pose&) const = default;
};

/// @param axis Unit vector.
/// @return The rotation by `angle` [rad] about it, counter-clockwise seen from its tip.
inline Quaternion rotationAbout(const Vector3& axis, double angle) {
  const auto [sine, cosine] = math::sinCos(angle / 2);
  return {cosine, sine * axis.x(), sine * axis.y(), sine * axis.z()};
}

/// Rotation from fixed-axis roll, pitch, yaw [rad] as SDF and URDF write it: R = Rz(yaw) Ry(pitch) Rx(roll).
inline Quaternion fromRollPitchYaw(double roll, double pitch, double yaw) {
  return rotationAbout(Vector3::UnitZ(), yaw) * rotationAbout(Vector3::UnitY(), pitch) *
         rotationAbout(Vector3::UnitX(), roll);
}

/// @return Heading [rad] in (-pi, pi]: the angle about z of the direction of the rotated x axis, seen from above.
inline double yawOf(const Quaternion& rotation) {
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  return math::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

/// @return Roll, pitch, yaw [rad] from which `fromRollPitchYaw` makes this rotation; the pitch is in [-pi/2, pi/2].
inline Vector3 rollPitchYawOf(const Quaternion& rotation) {
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  return {math::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
          math::asin(std::min(std::max(2 * (w * y - z * x), -1.0), 1.0)), yawOf(rotation)};
}

/// Id of an entity of one kind (a joint's id is not a link's). Never reused within a run; 0 is none.
template <class Kind>
struct Id {
  std::uint64_t value = 0;
  auto operator<=>(const Id&) const = default;
  explicit operator bool() const { return value != 0; }
};
using WorldId = Id<struct WorldKind>;
using ModelId = Id<struct ModelKind>;
using LinkId = Id<struct LinkKind>;
using JointId = Id<struct JointKind>;
using CollisionId = Id<struct CollisionKind>;
using SensorId = Id<struct SensorKind>;
using VisualId = Id<struct VisualKind>;
using LightId = Id<struct LightKind>;
using ActorId = Id<struct ActorKind>;
using BatteryId = Id<struct BatteryKind>;

}  // namespace pongsim
