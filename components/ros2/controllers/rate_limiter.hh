#pragma once

#include <limits>
#include <string>

#include "ros2/controllers/controller_parameters.hh"

namespace pongsim::ros2 {

/// Limits of a velocity and its derivatives, as in control_toolbox: not a number where there is none. An upper limit
/// alone holds in both directions.
struct RateLimits {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double minVelocity = kNone;
  double maxVelocity = kNone;
  /// Away from zero, in negative and positive direction.
  double minAcceleration = kNone;
  double maxAcceleration = kNone;
  /// Towards zero, from positive and negative velocities.
  double minDeceleration = kNone;
  double maxDeceleration = kNone;
  double minJerk = kNone;
  double maxJerk = kNone;

  /// Reads "linear.x.max_velocity" and the others, also by their names in Humble, for the prefix "linear.x".
  static RateLimits read(ControllerParameters& parameters, const std::string& prefix);
};

/// Limits jerk, then acceleration, then velocity, as control_toolbox's RateLimiter.
class RateLimiter {
 public:
  explicit RateLimiter(const RateLimits& limits = {});

  /// @param wanted Desired velocity.
  /// @param last The last velocity, and the one before it.
  /// @param dt [s]
  double limit(double wanted, double last, double beforeLast, double dt) const;

 private:
  RateLimits limits_;
};

}  // namespace pongsim::ros2
