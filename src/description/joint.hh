#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/sensor.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

enum class JointType { kRevolute, kContinuous, kPrismatic, kBall, kFixed, kUniversal, kRevolute2, kScrew, kGearbox };

/// @return SDF's name for the type: "revolute".
std::string_view name(JointType type);

/// `<mimic>`: an axis follows another one of its model, at multiplier * (position of that one - reference) + offset.
struct Mimic {
  /// Name of the other axis' joint in the model.
  std::string joint;
  SourcePosition position;
  /// 0 or 1.
  std::size_t axis = 0;
  double multiplier = 1;
  double offset = 0;
  double reference = 0;
  bool operator==(const Mimic&) const = default;
};

/// `<axis>`: a degree of freedom. Angles [rad] and their derivatives for a rotation axis, [m] for a translation axis.
struct JointAxis {
  /// Unit vector in the joint frame.
  Vector3 xyz = Vector3::UnitZ();
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  /// Maximum force or torque of a motor; infinite if the file gives none or a negative value.
  double effort = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double damping = 0;
  double friction = 0;
  double springReference = 0;
  double springStiffness = 0;
  std::optional<Mimic> mimic = {};
  bool operator==(const JointAxis&) const = default;
};

/// A `<joint>`. Links are named relative to the model: "wheel", "inner::wheel", or "world".
struct Joint {
  std::string name;
  SourcePosition position;
  JointType type = JointType::kFixed;
  std::string parent;
  std::string child;
  /// Pose of the joint frame in the child link's frame.
  Pose X_ChildJoint;
  /// Initial pose of the joint frame in the parent link's frame (in the world's, if that is the parent).
  Pose X_ParentJoint;
  /// For screws: translation of the child along the axis per turn [m]; positive: right-handed.
  double threadPitch = 1;
  /// For gearboxes: the ratio in theta2 = -ratio theta1, where theta1 is the parent's rotation about the first axis and
  /// theta2 the child's about the second, both relative to the reference link, to which the axes are fixed. Initially,
  /// the joint frame has the same pose on all three (in the world, if the reference link is "world").
  double gearboxRatio = 1;
  std::string gearboxReference;
  Pose X_ReferenceJoint;
  /// One for revolute, continuous, prismatic, screw; two for universal, revolute2, gearbox; none for ball, fixed.
  std::vector<JointAxis> axes;
  std::vector<Sensor> sensors;
  bool operator==(const Joint&) const = default;
};

}  // namespace pongsim::description
