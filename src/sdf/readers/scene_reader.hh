#pragma once

#include "description/scene.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<scene>` of a world; the format's defaults where there is none.
description::Scene readScene(const Element& world, Context& context);

}  // namespace pongsim::sdf
