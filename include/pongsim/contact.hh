#pragma once

#include "pongsim/types.hh"

namespace pongsim {

/// A point where two collisions touch. All vectors are in the world frame.
struct Contact {
  CollisionId collision1;
  CollisionId collision2;
  /// [m]
  Vector3 position;
  /// Unit vector, out of the second collision and into the first.
  Vector3 normal;
  /// Penetration depth [m], not negative.
  double depth = 0;
  /// Force on the first collision during the last step, including friction [N].
  Vector3 force;
};

}  // namespace pongsim
