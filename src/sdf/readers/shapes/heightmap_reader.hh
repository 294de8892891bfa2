#pragma once

#include <string>

#include "description/geometry.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<heightmap>`. Faults of its image give warnings, as in Fortress.
/// @param owner "collision 'c' of link 'l'", for warnings.
/// @param isCollision Whether its triangles are needed.
description::Heightmap readHeightmap(const Element& element, const std::string& owner, bool isCollision,
                                     Context& context);

}  // namespace pongsim::sdf
