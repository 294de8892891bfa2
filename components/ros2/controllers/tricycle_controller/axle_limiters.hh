#pragma once

#include <limits>
#include <string>

#include "ros2/controllers/controller_parameters.hh"

namespace pongsim::ros2 {

/// A range of magnitudes, the same in both directions. Where one of its ends is given, the other is 0 or 1000, as in
/// tricycle_controller; without both there is no limit.
struct MagnitudeRange {
  double least = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();

  /// Reads "traction.min_velocity" and "traction.max_velocity", for "traction." and "velocity".
  static MagnitudeRange read(ControllerParameters& parameters, const std::string& prefix, const std::string& name);
  /// @return The value with its magnitude in the range.
  double limit(double value) const;
};

/// Limits the traction wheel's speed as tricycle_controller does: jerk, acceleration or deceleration, velocity.
struct TractionLimiter {
  MagnitudeRange velocity, acceleration, deceleration, jerk;

  static TractionLimiter read(ControllerParameters& parameters);
  /// @param last The last speed, and the one before it [rad/s].
  double limit(double wanted, double last, double beforeLast, double dt) const;
};

/// Limits the steering angle likewise: acceleration, velocity, position.
struct SteeringLimiter {
  double leastPosition = std::numeric_limits<double>::quiet_NaN();
  double mostPosition = std::numeric_limits<double>::quiet_NaN();
  MagnitudeRange velocity, acceleration;

  static SteeringLimiter read(ControllerParameters& parameters);
  double limit(double wanted, double last, double beforeLast, double dt) const;
};

}  // namespace pongsim::ros2
