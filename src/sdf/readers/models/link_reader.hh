#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/link.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/models/auto_inertia.hh"
#include "sdf/readers/models/emitter_reader.hh"
#include "sdf/readers/sensors/sensor_reader.hh"
#include "sdf/readers/worlds/light_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

/// A link whose frames are still to be resolved.
struct LinkDraft {
  description::Link link;
  PoseText pose;
  /// A collision or visual whose pose is relative to a frame other than the link's.
  struct PlacedShape {
    bool isVisual;
    std::size_t index;
    PoseText pose;
  };
  std::vector<PlacedShape> shapes;
  /// Given if the inertia is computed from the collisions once these are placed.
  std::optional<AutoInertia> autoInertia = std::nullopt;
  /// Of the collisions; nothing where they give none [kg/m^3].
  std::vector<std::optional<double>> densities;
  std::vector<SensorDraft> sensors;
  std::vector<LightDraft> lights;
  std::vector<EmitterDraft> emitters;
};

/// @param owner "model 'robot'"
/// @param isStatic Whether the model never moves: then any mass is valid.
LinkDraft readLink(const Element& element, const std::string& owner, bool isStatic, Context& context);

/// Resolves the link's poses.
/// @param frameIndex Index of the link's frame in the resolved scope.
description::Link finishLink(LinkDraft&& draft, const Scope& scope, std::size_t frameIndex, Context& context);

}  // namespace pongsim::sdf
