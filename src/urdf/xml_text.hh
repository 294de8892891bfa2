#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Writes the `<robot>` for urdfdom, leaving out what is not URDF (`<gazebo>`, ...). Its parser thus only sees
/// well-formed text without comments, custom entities or deep nesting.
std::string xmlOf(const Element& robot);

}  // namespace pongsim::urdf
