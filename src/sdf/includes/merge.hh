#pragma once

#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::sdf {

/// What is needed to merge a model into another one, or into a world.
struct MergedModel {
  const Element& element;
  std::string name;
  /// The link that its frame is attached to.
  std::string canonicalLink;
  /// Pose of the model frame in the frame `relativeTo` of the enclosing model or world.
  Pose X_ReferenceModel;
  std::string relativeTo;
  /// Where it is included.
  SourcePosition includedFrom;
};

/// @return Fortress's name for the frame that replaces a merged model's own.
std::string mergedFrameName(const std::string& model);

/// @return The frame that replaces the model's own, and the model's parts. Parts that named the model frame, or were
/// relative to it, name the new frame. Includes are unchanged: pass their content to `setModelFrame`.
std::vector<Element> mergedParts(const MergedModel& model);

/// Replaces the model frame by `frame` in a part of a merged model, which may be relative to it by default.
void setModelFrame(Element& part, const std::string& frame);

}  // namespace pongsim::sdf
