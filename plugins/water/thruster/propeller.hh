#pragma once

#include <optional>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Parameters of a propeller.
struct PropellerSettings {
  /// [m]
  double diameter = 0.02;
  /// Of the fluid [kg/m^3].
  double density = 1000;
  /// Thrust divided by density, fourth power of the diameter and square of the speed in rad/s; default: `alpha1 +
  /// alpha2 * advance`.
  std::optional<double> coefficient = std::nullopt;
  /// Relative reduction of the water speed at the propeller.
  double wakeFraction = 0.2;
  double alpha1 = 1;
  double alpha2 = 0;
};

/// The speed of a propeller for a given thrust (T. I. Fossen, Guidance and Control of Ocean Vehicles, 1994, p. 95 and
/// 246, with rad/s instead of revolutions per second, as in Fortress).
class Propeller {
 public:
  explicit Propeller(const PropellerSettings& settings = {}) : settings_(settings) { reset(); }

  /// Sets the craft's speed [m/s]; needed if the coefficient depends on it.
  void setCraftSpeed(double speed) { craftSpeed_ = speed; }
  /// Sets the thrust [N], using the coefficient at the current speed.
  /// @return The speed [rad/s], with the sign of the thrust; the opposite one with a negative coefficient.
  double turnFor(double thrust);
  /// @return The speed for a thrust with the current coefficient.
  double speedFor(double thrust) const;
  /// @return The thrust at a speed [rad/s] with the current coefficient.
  double thrustAt(double speed) const;
  double speed() const { return speed_; }

  void reset() {
    coefficient_ = settings_.coefficient.value_or(1);
    speed_ = craftSpeed_ = 0;
  }
  void transfer(StateArchive& archive) {
    archive(coefficient_);
    archive(speed_);
    archive(craftSpeed_);
  }

 private:
  /// @return Thrust divided by the square of the speed.
  double thrustPerSquare() const;

  PropellerSettings settings_;
  double coefficient_ = 1;
  double speed_ = 0;
  double craftSpeed_ = 0;
};

}  // namespace pongsim
