#pragma once

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// How rotations are printed in degrees.
struct DegreeOptions {
  /// Angles that are nearer than `tolerance` to a multiple of this become the multiple; 0: none does [degrees].
  int snapTo = 0;
  double tolerance = 0.01;
};

/// Turns the rotation of each `<pose>` below `root` into roll, pitch and yaw in degrees, and says so in its attributes.
/// What stands in a `<plugin>` is left as it is, for its system reads it.
/// @param root Without errors: a pose that can't be read is left as it is.
void turnToDegrees(Element& root, const DegreeOptions& options);

}  // namespace pongsim::sdf
