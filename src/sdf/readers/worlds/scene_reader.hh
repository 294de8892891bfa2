#pragma once

#include "description/scene.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Reads the `<scene>` of a world; without one: the format's defaults.
description::Scene readScene(const Element& world, Context& context);

}  // namespace pongsim::sdf
