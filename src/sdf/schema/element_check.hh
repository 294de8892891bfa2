#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Warns about elements and attributes unknown to the format, once for each name. Anything inside a plugin, and names
/// with a prefix ("ignition:expressed_in"), are the user's own. In elements that no reader handles, values of the wrong
/// type and missing attributes are errors, as in Fortress.
/// @param root The `<sdf>` element.
void checkElements(const Element& root, Context& context);

}  // namespace pongsim::sdf
