#pragma once

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// How rotations are printed in degrees.
struct DegreeOptions {
  /// Angles closer than `tolerance` to a multiple of this snap to the multiple; 0: no snapping [degrees].
  int snapTo = 0;
  double tolerance = 0.01;
};

/// Converts the rotation of each `<pose>` below `root` to roll, pitch and yaw in degrees, and sets the pose's
/// attributes accordingly. Leaves the content of `<plugin>`s to their systems.
/// @param root Without errors: a pose that can't be read stays unchanged.
void turnToDegrees(Element& root, const DegreeOptions& options);

}  // namespace pongsim::sdf
