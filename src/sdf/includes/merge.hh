#pragma once

#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::sdf {

/// What has to be known of a model to merge it into another one.
struct MergedModel {
  const Element& element;
  std::string name;
  /// The link that its frame is attached to.
  std::string canonicalLink;
  /// Pose of the model frame in the frame `relativeTo` of what it is merged into.
  Pose X_ReferenceModel;
  std::string relativeTo;
  /// Where it is included.
  SourcePosition includedFrom;
};

/// @return The name that Fortress gives to the frame that stands for a merged model's own.
std::string mergedFrameName(const std::string& model);

/// @return That frame, and the model's parts with its name in place of the model frame that they name or are measured
/// in. Includes stay as they are: what they stand for has to be given to `setModelFrame`.
std::vector<Element> mergedParts(const MergedModel& model);

/// Measures a part of a merged model, of any kind, in that frame where it is measured in the model's own.
void setModelFrame(Element& part, const std::string& frame);

}  // namespace pongsim::sdf
