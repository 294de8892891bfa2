#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/joint.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/sensors/sensor_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A joint whose frames are still to be resolved.
struct JointDraft {
  description::Joint joint;
  PoseText pose;
  /// A frame's name and its position in the file.
  struct FrameName {
    std::string name;
    SourcePosition position;
  };
  FrameName parent;
  FrameName child;
  /// Only for gearboxes.
  FrameName reference;
  /// The frame in which each axis is given; empty: the joint's.
  std::vector<FrameName> axisFrames;
  std::vector<SensorDraft> sensors;
};

/// @param owner "model 'robot'" or "world 'w'"
JointDraft readJoint(const Element& element, const std::string& owner, Context& context);

/// Resolves the joint's links, poses and axes. If the parent is the world and the scope is a model's, `X_ParentJoint`
/// is the pose in the model frame, because the model's pose in the world is not known yet.
/// @param frameIndex Index of the joint's frame in the resolved scope.
/// @return Nothing, with a warning, if it connects a link to itself.
std::optional<description::Joint> finishJoint(JointDraft&& draft, const Scope& scope, std::size_t frameIndex,
                                              Context& context);

/// Removes the `<mimic>` of axes that follow none of the model's axes, with a warning each.
void checkMimics(std::vector<description::Joint>& joints, Context& context);

}  // namespace pongsim::sdf
