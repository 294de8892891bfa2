#pragma once

#include "description/environment.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads `<wind>`, `<magnetic_field>`, `<atmosphere>` and `<spherical_coordinates>` of a `<world>`.
description::Environment readEnvironment(const Element& world, Context& context);

}  // namespace pongsim::sdf
