#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Has urdfdom read a `<robot>`. What it says goes to `diagnostics`, placed at the link or joint that it names.
/// @return Null, and an error added, where it finds the robot unsound.
::urdf::ModelInterfaceSharedPtr readWithUrdfdom(const Element& robot, Diagnostics& diagnostics);

}  // namespace pongsim::urdf
