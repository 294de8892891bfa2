#pragma once

#include <string>

#include "description/geometry.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads a `<mesh>`. Faults of its file give warnings, as in Fortress.
/// @param owner "collision 'c' of link 'l'", for warnings.
/// @param isCollision Whether its triangles are needed.
description::Mesh readMesh(const Element& element, const std::string& owner, bool isCollision, Context& context);

}  // namespace pongsim::sdf
