#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Checks how the links and joints of a `<robot>` hang together: names are there and unique, joints name links that
/// are there, and all of it is one tree.
/// @return False, and errors added, where something is wrong.
bool checkStructure(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
