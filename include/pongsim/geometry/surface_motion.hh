#pragma once

#include <optional>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Motion of a collision's surface while the collision itself stays, as with a conveyor belt or a vehicle's track.
/// Friction accelerates touching bodies towards the surface's velocity, with `<mu>` along the motion and `<mu2>` across
/// it; `<fdir1>` has no effect, even at speed zero.
///
/// The model is that of M. Pecka, K. Zimmermann and T. Svoboda, "Fast simulation of vehicles with non-deformable
/// tracks", IROS 2017, pp. 6414-6419.
struct SurfaceMotion {
  /// Larger speeds are refused [m/s].
  static constexpr double kLargestSpeed = 1e6;

  /// Speed of the surface relative to its link [m/s], at most `kLargestSpeed`; negative: reversed.
  double speed = 0;
  /// Axis of the drums, in the link frame; its length is ignored. Where the outward normal is n, the surface moves
  /// along axis × n: with the axis +y, a horizontal top moves towards +x and the bottom towards -x. Where n is parallel
  /// to the axis, the surface does not move.
  Vector3 axis = Vector3::UnitY();
  /// Centre of rotation, world frame [m]: the surface moves in circles around it, at the same speed at each distance,
  /// in the direction closer to straight motion. Unset: straight motion.
  std::optional<Vector3> center = std::nullopt;

  bool operator==(const SurfaceMotion&) const = default;

  void transfer(StateArchive& archive) {
    archive(speed);
    archive(axis);
    archive(center);
  }
};

}  // namespace pongsim
