#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns of elements and attributes that the format does not know, once a name. What stands below a plugin, and
/// whatever has a name prefix ("ignition:expressed_in"), is the user's own.
/// @param root The `<sdf>` element.
void checkElements(const Element& root, Context& context);

}  // namespace pongsim::sdf
