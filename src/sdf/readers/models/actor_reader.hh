#pragma once

#include <string>

#include "description/actor.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// An actor whose pose is still to be resolved.
struct ActorDraft {
  description::Actor actor;
  PoseText pose;
};

/// @param owner "world 'w'"
ActorDraft readActor(const Element& element, const std::string& owner, Context& context);

/// Resolves the actor's pose.
/// @param scope Scope of the world, resolved.
description::Actor finishActor(ActorDraft&& draft, const Scope& scope, Context& context);

}  // namespace pongsim::sdf
