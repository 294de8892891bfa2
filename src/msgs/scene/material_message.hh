#pragma once

#include "description/material.hh"

namespace ignition::msgs {
class Material;
}

namespace pongsim::msgs {

/// Fills in a material as Fortress does. Pictures are named by their full path, or as in the description where they are
/// not there.
void setMaterial(const description::Material& material, ignition::msgs::Material& message);

/// @return The material that a message tells of. Pictures are named as the message does (`uri`) and not looked for.
description::Material materialFrom(const ignition::msgs::Material& message);

}  // namespace pongsim::msgs
