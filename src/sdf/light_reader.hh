#pragma once

#include <string>

#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/scope.hh"
#include "sdf/values.hh"

namespace pongsim::sdf {

/// A light of a world, complete but for its pose, which waits for the frames around it.
struct LightDraft {
  description::Light light;
  PoseText pose;
};

/// @param owner "world 'w'"
LightDraft readLight(const Element& element, const std::string& owner, Context& context);

/// Completes the light's pose.
/// @param scope That of the world, which is resolved.
description::Light finishLight(LightDraft&& draft, const Scope& scope, Context& context);

}  // namespace pongsim::sdf
