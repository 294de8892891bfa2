#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "pongsim/commands.hh"
#include "pongsim/math.hh"
#include "pongsim/types.hh"
#include "ros2/types/finite.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/simulation_interfaces.hh"

/// Answers of the services of simulation_interfaces.
namespace pongsim::ros2 {

using simulation_interfaces::Result;

inline Result succeeded() { return {Result::kResultOk, {}}; }
/// @param code One of `Result`'s, or of the service's own.
inline Result refused(std::uint8_t code, std::string why) { return {code, std::move(why)}; }
inline Result failed(std::string why) { return refused(Result::kResultOperationFailed, std::move(why)); }
inline Result notFound(std::string why) { return refused(Result::kResultNotFound, std::move(why)); }
inline bool isOk(const Result& result) { return result.result == Result::kResultOk; }

inline Vector3 vectorOf(const auto& from) { return {from.x, from.y, from.z}; }
inline void copyVector(const Vector3& from, auto& to) {
  to.x = from.x();
  to.y = from.y();
  to.z = from.z();
}

inline geometry_msgs::Pose poseMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  copyVector(pose.position, message.position);
  message.orientation = {pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), pose.rotation.w()};
  return message;
}

/// Allowed deviation of a quaternion's length from one; it is then normalized.
inline constexpr double kLooseLength = 0.01;

/// @return What is wrong with a pose in a request, or nothing.
inline std::optional<std::string> poseError(const geometry_msgs::Pose& pose) {
  if (!isFinite(pose)) return "the pose is not finite";
  if (!(vectorOf(pose.position).cwiseAbs().maxCoeff() <= kLargestCommand)) {
    return "the position is farther from the origin than 1000000 m";
  }
  const auto& q = pose.orientation;
  if (!(std::abs(math::hypot(math::hypot(q.x, q.y), math::hypot(q.z, q.w)) - 1) <= kLooseLength)) {
    return "the quaternion's length is not 1";
  }
  return std::nullopt;
}

/// @param pose Already checked.
inline Pose poseOf(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  return {vectorOf(pose.position), Quaternion(q.w, q.x, q.y, q.z).normalized()};
}

}  // namespace pongsim::ros2
