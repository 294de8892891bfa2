#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns about a part of a world or model that has an effect in Fortress but not here, once for each kind.
void warnIfUnsimulated(const Element& element, Context& context);

}  // namespace pongsim::sdf
