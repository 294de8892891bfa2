#pragma once

#include <optional>

#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// How the surface of a collision runs along where something touches it, while the collision itself stays: that of a
/// conveyor belt, or of a vehicle's track. Friction draws what touches it towards the surface's velocity, with `<mu>`
/// along the motion and `<mu2>` across; `<fdir1>` does not count then, also while `speed` is zero.
///
/// The model is that of M. Pecka, K. Zimmermann and T. Svoboda, "Fast simulation of vehicles with non-deformable
/// tracks", IROS 2017, pp. 6414-6419.
struct SurfaceMotion {
  /// Larger ones are refused [m/s].
  static constexpr double kLargestSpeed = 1e6;

  /// Of the surface, beside the velocity of its link [m/s]; below zero it runs the other way. At most `kLargestSpeed`.
  double speed = 0;
  /// Axis of the drums that the belt runs round, in the link frame; its length does not count. Where the surface faces
  /// outwards along n, the belt runs along axis × n: with the axis +y a level top runs to +x, the bottom to -x. Where n
  /// lies along the axis nothing runs.
  Vector3 axis = Vector3::UnitY();
  /// A point in the world frame [m] round which the surface runs in circles, at the same speed at each distance: along
  /// the tangent, the way round that is nearer to the straight one. Without it the belt runs straight on.
  std::optional<Vector3> center = std::nullopt;

  bool operator==(const SurfaceMotion&) const = default;

  void transfer(StateArchive& archive) {
    archive(speed);
    archive(axis);
    archive(center);
  }
};

}  // namespace pongsim
