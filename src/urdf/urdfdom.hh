#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Parses a `<robot>` with urdfdom. Its messages go to `diagnostics`, with the position of the link or joint that they
/// name.
/// @return Null, with an error, if urdfdom rejects the robot.
::urdf::ModelInterfaceSharedPtr readWithUrdfdom(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
