#pragma once

#include "description/scene.hh"

namespace ignition::msgs {
class Scene;
}

namespace pongsim::msgs {

/// Fills in the rest of the scene beside models and lights, as Fortress does, that is without fog.
void setSurroundings(const description::Scene& surroundings, ignition::msgs::Scene& message);

/// @return The same from a message.
description::Scene surroundingsFrom(const ignition::msgs::Scene& message);

}  // namespace pongsim::msgs
