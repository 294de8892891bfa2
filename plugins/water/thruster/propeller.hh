#pragma once

#include <optional>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// What the file says of a propeller.
struct PropellerSettings {
  /// [m]
  double diameter = 0.02;
  /// Of the fluid [kg/m^3].
  double density = 1000;
  /// Thrust by density, fourth power of the diameter and square of the speed in rad/s; without it, it is
  /// `alpha1 + alpha2 * advance`.
  std::optional<double> coefficient = std::nullopt;
  /// By how much less than the craft the water at the propeller comes along.
  double wakeFraction = 0.2;
  double alpha1 = 1;
  double alpha2 = 0;
};

/// How fast a propeller must turn for a thrust (T. I. Fossen, Guidance and Control of Ocean Vehicles, 1994, p. 95 and
/// 246, with rad/s in place of turns a second, as Fortress has it).
class Propeller {
 public:
  explicit Propeller(const PropellerSettings& settings = {}) : settings_(settings) { reset(); }

  /// Says how fast the craft goes [m/s]; counts where the coefficient follows from it.
  void setCraftSpeed(double speed) { craftSpeed_ = speed; }
  /// Turns it for that thrust [N], with the coefficient that its speed so far gives.
  /// @return The speed [rad/s], with the sign of the thrust.
  double turnFor(double thrust);
  /// @return The speed for a thrust with the coefficient as it is now.
  double speedFor(double thrust) const;
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
  PropellerSettings settings_;
  double coefficient_ = 1;
  double speed_ = 0;
  double craftSpeed_ = 0;
};

}  // namespace pongsim
