#pragma once

#include <string>

#include "description/geometry.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<geometry>` of a collision or visual.
/// @param owner "collision 'c' of link 'l'", for errors.
description::Geometry readGeometry(const Element& element, const std::string& owner, Context& context);

}  // namespace pongsim::sdf
