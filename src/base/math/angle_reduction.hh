#pragma once

namespace pongsim::math {

/// An angle as quarter turns and a remainder: `quarters` * pi/2 + `rest` + `tail`.
struct ReducedAngle {
  /// The number of quarter turns, modulo 4.
  unsigned quarters;
  /// At most slightly more than pi/4.
  double rest;
  /// Correction to `rest`, below its last place.
  double tail;
};

/// @param angle Finite.
ReducedAngle reduceAngle(double angle);

}  // namespace pongsim::math
