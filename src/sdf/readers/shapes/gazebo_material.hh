#pragma once

#include <string_view>

#include "description/material.hh"

namespace pongsim::sdf {

/// @return The material that Gazebo's own script of materials has under a name, such as "Gazebo/Blue"; null if there is
/// none. Without the pictures that some have.
const description::Material* gazeboMaterial(std::string_view name);

}  // namespace pongsim::sdf
