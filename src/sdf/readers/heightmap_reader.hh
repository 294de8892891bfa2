#pragma once

#include <string>

#include "description/geometry.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<heightmap>`. What is wrong with its image is a warning, as in Fortress.
/// @param owner "collision 'c' of link 'l'", for warnings.
/// @param isCollision Its triangles are needed.
description::Heightmap readHeightmap(const Element& element, const std::string& owner, bool isCollision,
                                     Context& context);

}  // namespace pongsim::sdf
