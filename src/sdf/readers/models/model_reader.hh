#pragma once

#include <memory>
#include <string>

#include "description/model.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A model whose own pose is still to be resolved.
struct ModelDraft {
  description::Model model;
  /// The resolved frames.
  std::unique_ptr<Scope> scope;
  PoseText pose;
  std::string placementFrame;
};

/// @param owner "world 'w'", or the enclosing model, "model 'robot'"
/// @param isInStatic Whether it is nested in a static model.
ModelDraft readModel(const Element& element, const std::string& owner, bool isInStatic, Context& context);

}  // namespace pongsim::sdf
