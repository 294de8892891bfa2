#pragma once

#include <string>

#include "description/sensor.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A sensor whose frames are still to be resolved.
struct SensorDraft {
  description::Sensor sensor;
  PoseText pose;
  /// Pose of a camera's optical centre.
  PoseText cameraPose;
};

/// Warns, once for each type, if it is not simulated yet.
/// @param owner "link 'l' of model 'robot'"
SensorDraft readSensor(const Element& element, const std::string& owner, Context& context);

/// Resolves the sensor's pose.
/// @param scope Scope of the model, resolved.
/// @param X_ScopeParent Pose of its parent link or joint.
description::Sensor finishSensor(SensorDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context);

}  // namespace pongsim::sdf
