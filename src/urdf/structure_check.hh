#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Checks the structure of a `<robot>`: names exist and are unique, joints name existing links, and everything is one
/// tree.
/// @return False, with errors, if something is wrong.
bool checkStructure(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
