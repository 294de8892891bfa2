#pragma once

#include <chrono>
#include <compare>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "pongsim/export.hh"

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
///
/// A template, so that a file that composes no poses does not have to compile what that takes of Eigen.
template <class Scalar>
struct BasicPose {
  Eigen::Vector3<Scalar> position = Eigen::Vector3<Scalar>::Zero();
  Eigen::Quaternion<Scalar> rotation = Eigen::Quaternion<Scalar>::Identity();

  BasicPose operator*(const BasicPose& other) const {
    return {position + rotation * other.position, (rotation * other.rotation).normalized()};
  }
  Eigen::Vector3<Scalar> operator*(const Eigen::Vector3<Scalar>& point) const { return position + rotation * point; }
  BasicPose inverse() const {
    const Eigen::Quaternion<Scalar> inverted = rotation.conjugate();
    return {-(inverted * position), inverted};
  }
  bool operator==(const BasicPose&) const = default;
};
using Pose = BasicPose<double>;

/// @param axis Unit vector.
/// @return The rotation by `angle` [rad] about it, counter-clockwise seen from its tip.
PONGSIM_API Quaternion rotationAbout(const Vector3& axis, double angle);

/// Rotation from fixed-axis roll, pitch, yaw [rad] as SDF and URDF write it: R = Rz(yaw) Ry(pitch) Rx(roll).
PONGSIM_API Quaternion fromRollPitchYaw(double roll, double pitch, double yaw);

/// @return Heading [rad] in (-pi, pi]: the angle about z of the direction of the rotated x axis, seen from above.
PONGSIM_API double yawOf(const Quaternion& rotation);

/// @return Roll, pitch, yaw [rad] from which `fromRollPitchYaw` makes this rotation; the pitch is in [-pi/2, pi/2].
PONGSIM_API Vector3 rollPitchYawOf(const Quaternion& rotation);

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
