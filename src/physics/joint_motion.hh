#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <cstddef>

namespace pongsim::physics {

/// How a joint lets its child move relative to its parent in a step, at the point where its rows act, world frame: at
/// the given velocity plus that of its freedoms, S q'. Says the same as the rows without bounds, but for their
/// compliance.
struct JointMotion {
  struct Freedom {
    /// S.
    btVector3 linear;
    btVector3 angular;
    /// Impulse per velocity, relative to `velocity` [N s per m/s, N m s per rad/s].
    double damping = 0;
    double velocity = 0;
  };

  /// From the bodies' centres of mass to the point.
  btVector3 parentArm;
  btVector3 childArm;
  btVector3 linear{0, 0, 0};
  btVector3 angular{0, 0, 0};
  std::array<Freedom, 3> freedoms;
  /// Number of freedoms.
  std::size_t count = 0;
};

}  // namespace pongsim::physics
