#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "msgs/scene/changed_properties.hh"
#include "pongsim/message.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::msgs {

/// Fills in an `ignition.msgs.Scene` as Fortress does: the models with their links, visuals, lights and sensors, and
/// the world's lights. Poses are the current ones, each in its parent's frame.
/// @param isWanted Called with the id of each top-level model and each light of the world. Empty: all are included.
void setScene(const world::Entities& entities, const world::State& state, Message& scene,
              const std::function<bool(std::uint64_t)>& isWanted = {}, const ChangedProperties& changed = {});

/// @return The tree of entities, as text for Graphviz, with the same content as the scene.
std::string sceneGraph(const world::Entities& entities);

}  // namespace pongsim::msgs
