#pragma once

namespace pongsim::math {

/// An angle as quarter turns and what is left: `quarters` * pi/2 + `rest` + `tail`.
struct ReducedAngle {
  /// The number of quarter turns, modulo 4.
  unsigned quarters;
  /// At most pi/4 and a little.
  double rest;
  /// What `rest` lacks, below its last place.
  double tail;
};

/// @param angle Finite.
ReducedAngle reduceAngle(double angle);

}  // namespace pongsim::math
