#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns of the sensors below a link or joint, once a type.
void warnOfSensors(const Element& element, Context& context);

/// Warns of elements below a world or model that would act on it in Fortress and do not here, once a kind.
void warnOfUnsimulated(const Element& element, Context& context);

/// Adds an error for each `<include>`.
/// @return Whether there is one.
bool refuseIncludes(const Element& element, Context& context);

}  // namespace pongsim::sdf
