#pragma once

#include <algorithm>
#include <numbers>

#include "pongsim/geometry/volume_moments.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A ball centred on the origin.
struct Ball {
  /// [m]
  double radius = 0;

  /// @param up Unit vector in the frame of the ball.
  /// @param height Height of a plane along `up`, from the origin of that frame [m].
  /// @return The part below the plane.
  VolumeMoments below(const Vector3& up, double height) const {
    const double u = std::clamp(height, -radius, radius);
    const double square = radius * radius;
    const double rim = square - u * u;
    VolumeMoments part;
    part.volume = std::numbers::pi * (square * (u + radius) - (u * u * u + square * radius) / 3);
    part.first = (-std::numbers::pi / 4 * rim * rim) * up;
    return part;
  }
};

}  // namespace pongsim
