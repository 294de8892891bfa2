#pragma once

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

/// @return The `<origin>` of a link's part, a joint or a robot, already checked by `checkRobot`; the identity without
/// one. urdfdom reads it too, but with the C library's sines, whose bits differ between machines.
Pose originOf(const Element& part);

}  // namespace pongsim::urdf
