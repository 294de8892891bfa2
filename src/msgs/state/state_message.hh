#pragma once

#include "pongsim/message.hh"
#include "pongsim/scene.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::msgs {

/// Fills in the `state` and the simulated side of the `stats` of an `ignition.msgs.SerializedStepMap`: the entities
/// with their components, named and written as those of Fortress: numbers as text with blanks between them, a pose as x
/// y z roll pitch yaw, what is more as the bytes of a message (`Inertial`, `Axis`, `Geometry`, `Material`, `Light`,
/// `Sensor`).
/// @throws std::bad_alloc for want of memory; the state is empty then, and what was in it is never freed.
void setState(const world::Entities& entities, const world::State& state, StateContent content, bool isPaused,
              Message& step);

}  // namespace pongsim::msgs
