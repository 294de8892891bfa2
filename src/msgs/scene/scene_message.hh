#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "pongsim/message.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::msgs {

/// Fills in an `ignition.msgs.Scene` as Fortress does: the models with their links, visuals, lights and sensors, and
/// the lights of the world. Poses are those of now, each in the frame of what holds it.
/// @param isWanted Told the id of each model at the top level and each light of the world. Empty: all are.
void setScene(const world::Entities& entities, const world::State& state, Message& scene,
              const std::function<bool(std::uint64_t)>& isWanted = {});

/// @return Who holds whom, as text for Graphviz: the same as in the scene.
std::string sceneGraph(const world::Entities& entities);

}  // namespace pongsim::msgs
