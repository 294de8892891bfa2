#pragma once

#include <memory>
#include <string>

#include "description/model.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A model, complete but for its own pose, which waits for the frames around it.
struct ModelDraft {
  description::Model model;
  /// Its frames, resolved.
  std::unique_ptr<Scope> scope;
  PoseText pose;
  std::string placementFrame;
};

/// @param owner "world 'w'" or the model that it is nested in, "model 'robot'"
/// @param isInStatic It is nested in a static model.
ModelDraft readModel(const Element& element, const std::string& owner, bool isInStatic, Context& context);

}  // namespace pongsim::sdf
