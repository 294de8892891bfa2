#pragma once

#include <string>

#include "description/model.hh"
#include "description/particle_emitter.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A particle emitter whose pose is still to be resolved.
struct EmitterDraft {
  description::ParticleEmitter emitter;
  PoseText pose;
};

/// Reads a `<particle_emitter>`. One with invalid numbers is a warning, and emits nothing.
/// @param owner "link 'l' of model 'm'"
EmitterDraft readEmitter(const Element& element, const std::string& owner, Context& context);

/// Resolves the emitter's pose.
/// @param scope Scope of the model, resolved.
description::ParticleEmitter finishEmitter(EmitterDraft&& draft, const Scope& scope, const Pose& X_ScopeLink,
                                           Context& context);

/// Adds the emitters that the system `particle-emitter` in a model describes to the model's canonical link. Those with
/// what is invalid in them, or a name that is taken, are left out with a warning.
void addSystemEmitters(description::Model& model, const std::string& label, Context& context);

}  // namespace pongsim::sdf
