#pragma once

#include <limits>

#include "pongsim/state_archive.hh"

namespace pongsim {

/// Bounds of a velocity and of its first two derivatives [m/s, m/s^2, m/s^3, or rad]; infinite at the start.
struct SpeedLimits {
  double minVelocity = -std::numeric_limits<double>::infinity();
  double maxVelocity = std::numeric_limits<double>::infinity();
  double minAcceleration = -std::numeric_limits<double>::infinity();
  double maxAcceleration = std::numeric_limits<double>::infinity();
  double minJerk = -std::numeric_limits<double>::infinity();
  double maxJerk = std::numeric_limits<double>::infinity();
};

/// Keeps a commanded velocity within limits of jerk, then acceleration, then velocity, in the order of ignition-math's
/// SpeedLimiter.
class SpeedLimiter {
 public:
  explicit SpeedLimiter(const SpeedLimits& limits = {}) : limits_(limits) {}

  /// @param wanted Velocity asked for.
  /// @param dt Time since the last call [s]; where it is zero only the velocity is limited.
  /// @return The velocity to command now, from which the next call goes on.
  double limit(double wanted, double dt);

  void reset() { last_ = beforeLast_ = 0; }

  void transfer(StateArchive& archive) {
    archive(last_);
    archive(beforeLast_);
  }

 private:
  SpeedLimits limits_;
  double last_ = 0;
  double beforeLast_ = 0;
};

}  // namespace pongsim
