#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns of elements and attributes that the format does not know, once a name. What stands below a plugin, and
/// whatever has a name prefix ("ignition:expressed_in"), is the user's own. Where no reader looks, values of the wrong
/// type and missing attributes are errors, as in Fortress.
/// @param root The `<sdf>` element.
void checkElements(const Element& root, Context& context);

}  // namespace pongsim::sdf
