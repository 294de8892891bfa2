#pragma once

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

/// @return What the `<origin>` of a link's part, a joint or a robot says, which `checkRobot` has looked at; nothing
/// turned or moved without one. urdfdom reads it too, but asks the C library for sines, whose bits differ by machine.
Pose originOf(const Element& part);

}  // namespace pongsim::urdf
