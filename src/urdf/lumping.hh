#pragma once

#include "urdf/extensions.hh"
#include "urdf/robot.hh"

namespace pongsim::urdf {

/// Merges each link with a fixed joint into its nearest ancestor that is kept, combining their inertials and moving the
/// joints of its children to that ancestor. Exceptions are joints kept by `<gazebo>` and joints to a link "world".
void lumpFixedJoints(Robot& robot, const Extensions& extensions);

}  // namespace pongsim::urdf
