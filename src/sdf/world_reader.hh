#pragma once

#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

description::World readWorld(const Element& element, Context& context);

}  // namespace pongsim::sdf
