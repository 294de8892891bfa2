#pragma once

#include "description/material.hh"

namespace ignition::msgs {
class Material;
}

namespace pongsim::msgs {

/// Fills in a material as Fortress does. Textures are given by full path, or as in the description if they do not
/// exist.
void setMaterial(const description::Material& material, ignition::msgs::Material& message);

/// @return The material in a message. Textures keep the message's names (`uri`) and are not looked for.
description::Material materialFrom(const ignition::msgs::Material& message);

}  // namespace pongsim::msgs
