#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
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

/// What a file says of limits; what it does not say is nothing.
struct SpeedLimitParameters {
  std::optional<double> minVelocity, maxVelocity, minAcceleration, maxAcceleration, minJerk, maxJerk;
};

/// Adds the parameters `<min_velocity>`, `<max_velocity>`, `<min_acceleration>`, `<max_acceleration>`, `<min_jerk>` and
/// `<max_jerk>`.
/// @param kind Stands in the names after the first word: "linear" makes `<min_linear_velocity>`. Empty for both.
/// @param unit Of the velocity: "m/s".
PONGSIM_API void declareSpeedLimits(Declaration& declaration, SpeedLimitParameters& parameters, std::string_view kind,
                                    std::string_view unit);

/// @return The limits of one kind of motion: those of its own, else those for all kinds.
/// @param kind For the error: "linear".
/// @throws Error at `plugin` where a smallest value is above the largest.
PONGSIM_API SpeedLimits speedLimits(const SpeedLimitParameters& own, const SpeedLimitParameters& all,
                                    std::string_view kind, const Element& plugin);

/// Keeps a commanded velocity within limits of jerk, then acceleration, then velocity, in the order of ignition-math's
/// SpeedLimiter.
class PONGSIM_API SpeedLimiter {
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
