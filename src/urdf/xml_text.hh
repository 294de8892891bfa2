#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::urdf {

/// Writes the `<robot>` for urdfdom, without what is not URDF (`<gazebo>`, ...). That parser so sees nothing but
/// well-formed text without comments, entities of its own or deep nesting.
std::string xmlOf(const Element& robot);

}  // namespace pongsim::urdf
