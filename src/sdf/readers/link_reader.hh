#pragma once

#include <string>
#include <vector>

#include "description/link.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/light_reader.hh"
#include "sdf/readers/sensor_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A link and what of it waits for the frames of its model.
struct LinkDraft {
  description::Link link;
  PoseText pose;
  /// Collisions and visuals that are measured in another frame than the link's.
  struct Part {
    bool isVisual;
    std::size_t index;
    PoseText pose;
  };
  std::vector<Part> parts;
  std::vector<SensorDraft> sensors;
  std::vector<LightDraft> lights;
};

/// @param owner "model 'robot'"
/// @param isStatic The model never moves, so that masses mean nothing.
LinkDraft readLink(const Element& element, const std::string& owner, bool isStatic, Context& context);

/// Completes the link's poses.
/// @param entry The link's number in the scope, which is resolved.
description::Link finishLink(LinkDraft&& draft, const Scope& scope, std::size_t entry, Context& context);

}  // namespace pongsim::sdf
