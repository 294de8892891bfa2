#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns of a part of a world or model if it would act on it in Fortress and does not here, once a kind.
void warnIfUnsimulated(const Element& element, Context& context);

}  // namespace pongsim::sdf
