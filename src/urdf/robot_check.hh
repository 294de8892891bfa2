#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Checks a `<robot>` element by element: what must be there is, and numbers are numbers. What URDF does not know is
/// passed by, with a warning where it is spelt almost like what it knows.
/// @return False, and errors added, where something is wrong.
bool checkRobot(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
