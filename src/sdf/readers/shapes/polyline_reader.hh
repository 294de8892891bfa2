#pragma once

#include <string>

#include "description/geometry.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads all `<polyline>`s of a `<geometry>` as one shape. Warns if it can't be filled.
/// @param geometry Contains at least one.
/// @param owner "collision 'c' of link 'l'", for warnings.
description::Polyline readPolylines(const Element& geometry, const std::string& owner, bool isCollision,
                                    Context& context);

}  // namespace pongsim::sdf
