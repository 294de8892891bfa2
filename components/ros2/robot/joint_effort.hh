#pragma once

#include "pongsim/handles.hh"

namespace pongsim::ros2 {

/// @return The force or torque about the axis that the joint exerted on its child in the last step, positive if it
/// increases the velocity: the total of motor, commands, friction, damping and limits [N m or N]. Measured from the
/// first call on, which returns zero.
inline double jointEffort(const Joint& joint, int axis = 0) {
  const std::optional<Link> parent = joint.parent();
  // the first of two axes turns with the parent; a single one has the same direction in both frames
  const Pose X_WorldJoint = axis == 0 && joint.axisCount() > 1
                                ? (parent ? parent->pose() : Pose()) * joint.poseInParent()
                                : joint.child().pose() * joint.poseInChild();
  const Vector3 direction = X_WorldJoint.rotation * joint.axisInfo(axis).xyz;
  const Wrench reaction = joint.reaction();
  return direction.dot(joint.type() == "prismatic" ? reaction.force : reaction.torque);
}

}  // namespace pongsim::ros2
