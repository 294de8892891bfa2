#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "description/sensor.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

enum class JointType { kRevolute, kContinuous, kPrismatic, kBall, kFixed, kUniversal, kRevolute2, kScrew, kGearbox };

/// @return The format's name of the type: "revolute".
std::string_view name(JointType type);

/// `<axis>`: one degree of freedom. Angles [rad] and their derivatives for a turning axis, [m] for a sliding one.
struct JointAxis {
  /// Unit vector in the joint frame.
  Vector3 xyz = Vector3::UnitZ();
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  /// Largest force or torque of a motor; infinite where the file gives none or a negative one.
  double effort = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double damping = 0;
  double friction = 0;
  double springReference = 0;
  double springStiffness = 0;
  bool operator==(const JointAxis&) const = default;
};

/// What a `<joint>` says. Links are named as the model sees them: "wheel", "inner::wheel", or "world".
struct Joint {
  std::string name;
  SourcePosition position;
  JointType type = JointType::kFixed;
  std::string parent;
  std::string child;
  /// Pose of the joint frame in the child link's frame.
  Pose X_ChildJoint;
  /// Pose of the joint frame, at the start, in the parent link's frame (in the world's, if that is the parent).
  Pose X_ParentJoint;
  /// Of a screw: how far the child moves along the axis in one turn [m], right-handed where positive.
  double threadPitch = 1;
  /// Of a gearbox: it holds theta2 = -ratio theta1, theta1 being how far the parent has turned about the first axis and
  /// theta2 how far the child has turned about the second, both seen from the reference link, to which the axes are
  /// fixed. The joint frame in that one (in the world's, if it is "world") is where it is in the two others.
  double gearboxRatio = 1;
  std::string gearboxReference;
  Pose X_ReferenceJoint;
  /// One for revolute, continuous, prismatic, screw; two for universal, revolute2, gearbox; none for ball, fixed.
  std::vector<JointAxis> axes;
  std::vector<Sensor> sensors;
  bool operator==(const Joint&) const = default;
};

}  // namespace pongsim::description
