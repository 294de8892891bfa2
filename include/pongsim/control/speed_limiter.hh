#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Limits of a velocity and its first two derivatives [m/s, m/s^2, m/s^3, or rad]; infinite by default.
struct SpeedLimits {
  double minVelocity = -std::numeric_limits<double>::infinity();
  double maxVelocity = std::numeric_limits<double>::infinity();
  double minAcceleration = -std::numeric_limits<double>::infinity();
  double maxAcceleration = std::numeric_limits<double>::infinity();
  double minJerk = -std::numeric_limits<double>::infinity();
  double maxJerk = std::numeric_limits<double>::infinity();
};

/// Limits given in a file; unset where not given.
struct SpeedLimitParameters {
  std::optional<double> minVelocity, maxVelocity, minAcceleration, maxAcceleration, minJerk, maxJerk;
};

/// Adds the parameters `<min_velocity>`, `<max_velocity>`, `<min_acceleration>`, `<max_acceleration>`, `<min_jerk>` and
/// `<max_jerk>`.
/// @param kind Inserted into the names: "linear" makes `<min_linear_velocity>`. Empty for limits of both.
/// @param unit Unit of the velocity: "m/s".
PONGSIM_API void declareSpeedLimits(Declaration& declaration, SpeedLimitParameters& parameters, std::string_view kind,
                                    std::string_view unit);

/// @return The limits of one kind of motion: its own, else those for all kinds.
/// @param kind For the error message: "linear".
/// @throws Error at `plugin` if a minimum is above its maximum.
PONGSIM_API SpeedLimits speedLimits(const SpeedLimitParameters& own, const SpeedLimitParameters& all,
                                    std::string_view kind, const Element& plugin);

/// Limits jerk, then acceleration, then velocity of a commanded velocity, in the order of ignition-math's SpeedLimiter.
class PONGSIM_API SpeedLimiter {
 public:
  explicit SpeedLimiter(const SpeedLimits& limits = {}) : limits_(limits) {}

  /// @param wanted Desired velocity.
  /// @param dt Time since the last call [s]; if zero, only the velocity is limited.
  /// @return The limited velocity, from which the next call continues.
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
