#pragma once

#include <string>

#include "description/sensor.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A sensor and what of it waits for the frames of its model.
struct SensorDraft {
  description::Sensor sensor;
  PoseText pose;
  /// Of the eye of a camera.
  PoseText cameraPose;
};

/// Warns, once a type, of one that is not simulated yet.
/// @param owner "link 'l' of model 'robot'"
SensorDraft readSensor(const Element& element, const std::string& owner, Context& context);

/// Completes the sensor's pose.
/// @param scope That of the model, which is resolved.
/// @param X_ScopeParent Pose of the link or the joint that holds it.
description::Sensor finishSensor(SensorDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context);

}  // namespace pongsim::sdf
