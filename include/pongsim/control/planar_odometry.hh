#pragma once

namespace pongsim {

/// Estimated pose of a ground vehicle relative to its start, and its velocity.
struct PlanarOdometry {
  /// [m]
  double x = 0;
  double y = 0;
  /// [rad]
  double heading = 0;
  /// Forward [m/s].
  double linearVelocity = 0;
  /// Anticlockwise [rad/s].
  double angularVelocity = 0;
  /// To the left [m/s], for vehicles that can move sideways.
  double lateralVelocity = 0;
};

}  // namespace pongsim
