#pragma once

#include <string>

#include "description/light.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A light of a world or link whose pose is still to be resolved.
struct LightDraft {
  description::Light light;
  PoseText pose;
};

/// @param owner "world 'w'", "link 'l' of model 'm'"
LightDraft readLight(const Element& element, const std::string& owner, Context& context);

/// Resolves the light's pose.
/// @param scope Scope of the world or model, resolved.
/// @param X_ScopeParent Pose of its parent: the world, or a link.
description::Light finishLight(LightDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context);

}  // namespace pongsim::sdf
