#pragma once

namespace pongsim {

/// Where a vehicle on the ground believes to be, from its own start, and how fast it moves.
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
  /// To the left [m/s], of a vehicle that can.
  double lateralVelocity = 0;
};

}  // namespace pongsim
