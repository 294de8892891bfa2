#pragma once

#include "urdf/extensions.hh"
#include "urdf/robot.hh"

namespace pongsim::urdf {

/// Makes links behind fixed joints part of the next link up that is not, but for joints that `<gazebo>` keeps and for
/// joints to a link "world": their inertials are combined, and joints further down hang on that link.
void lumpFixedJoints(Robot& robot, const Extensions& extensions);

}  // namespace pongsim::urdf
