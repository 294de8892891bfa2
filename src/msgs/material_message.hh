#pragma once

#include "description/material.hh"

namespace ignition::msgs {
class Material;
}

namespace pongsim::msgs {

/// Fills in a material as Fortress does. Pictures are named by their full path, or as in the description where they are
/// not there.
void setMaterial(const description::Material& material, ignition::msgs::Material& message);

}  // namespace pongsim::msgs
