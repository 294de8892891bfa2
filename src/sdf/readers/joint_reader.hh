#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/joint.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/sensor_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A joint and what of it waits for the frames of its model or world.
struct JointDraft {
  description::Joint joint;
  PoseText pose;
  /// A frame as the file names it, and where.
  struct FrameName {
    std::string name;
    SourcePosition position;
  };
  FrameName parent;
  FrameName child;
  /// Of a gearbox.
  FrameName reference;
  /// For each axis the frame that its vector is given in; empty: the joint's.
  std::vector<FrameName> axisFrames;
  std::vector<SensorDraft> sensors;
};

/// @param owner "model 'robot'" or "world 'w'"
JointDraft readJoint(const Element& element, const std::string& owner, Context& context);

/// Completes the joint's links, poses and axes. Where the parent is the world and the scope is a model's,
/// `X_ParentJoint` is the pose in the model frame, for the model's place in the world is not known yet.
/// @param entry The joint's number in the scope, which is resolved.
/// @return Nothing, and a warning added, where it ties a link to itself.
std::optional<description::Joint> finishJoint(JointDraft&& draft, const Scope& scope, std::size_t entry,
                                              Context& context);

}  // namespace pongsim::sdf
