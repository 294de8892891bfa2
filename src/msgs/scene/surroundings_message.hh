#pragma once

#include "description/scene.hh"

namespace ignition::msgs {
class Scene;
}

namespace pongsim::msgs {

/// Fills in what is to be seen beside models and lights as Fortress does, that is without fog.
void setSurroundings(const description::Scene& surroundings, ignition::msgs::Scene& message);

/// @return What a message says of that.
description::Scene surroundingsFrom(const ignition::msgs::Scene& message);

}  // namespace pongsim::msgs
