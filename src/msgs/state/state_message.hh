#pragma once

#include "msgs/scene/changed_properties.hh"
#include "pongsim/message.hh"
#include "pongsim/scene.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::msgs {

/// Fills in the `state` and the simulated part of the `stats` of an `ignition.msgs.SerializedStepMap`: the entities and
/// their components, with Fortress's names and formats. Numbers are text separated by spaces, a pose is x y z roll
/// pitch yaw, and anything more complex is a serialized message (`Inertial`, `Axis`, `Geometry`, `Material`, `Light`,
/// `Sensor`).
/// @throws std::bad_alloc if memory runs out; the state is then empty, and its previous content is leaked.
void setState(const world::Entities& entities, const world::State& state, StateContent content, bool isPaused,
              Message& step, const ChangedProperties& changed = {});

}  // namespace pongsim::msgs
