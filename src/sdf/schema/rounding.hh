#pragma once

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Rounds all numbers with a fraction, alone or in vectors, poses and colours, to some significant digits. Leaves the
/// content of `<plugin>`s to their systems.
/// @param root The `<sdf>` element.
/// @param digits From 1.
void roundNumbers(Element& root, int digits);

}  // namespace pongsim::sdf
