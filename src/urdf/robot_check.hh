#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Checks a `<robot>` element by element: required parts exist, and numbers are numbers. Elements unknown to URDF are
/// ignored, with a warning if the name looks like a misspelling.
/// @return False, with errors, if something is wrong.
bool checkRobot(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
