#pragma once

#include <array>
#include <cstddef>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A battery whose open-circuit voltage is a linear function of its charge: V = e0 + e1 (1 - q/c) - r i, with the
/// charge q, the capacity c, the internal resistance r and the current i, which is P/V after a low-pass filter.
class LinearCell {
 public:
  struct Parameters {
    /// At the start [V].
    double voltage = 0;
    /// e0: open-circuit voltage when full [V].
    double constantVoltage = 0;
    /// e1: change of that voltage from full to empty, usually negative [V].
    double linearVoltage = 0;
    /// [Ah], above 0.
    double capacity = 1;
    /// [Ah]
    double initialCharge = 1;
    /// [Ohm]
    double resistance = 0;
    /// Time constant of the current [s], above 0.
    double smoothing = 1;
    /// Time from empty to full [h], above 0.
    double chargingTime = 1;
    /// Whether the state of charge is q/c. If not, each step subtracts the charge of the last hundred steps, as in
    /// Fortress by default (its issue 225): about a hundred times too fast.
    bool countsOnce = false;
  };

  explicit LinearCell(const Parameters& parameters) : parameters_(parameters) { reset(); }

  void reset();

  /// Advances by `dt` [s].
  /// @param load Power drawn [W].
  void update(double dt, double load, bool isCharging);

  /// @return State of charge, 1 when full; it may fall below zero.
  double stateOfCharge() const { return stateOfCharge_; }
  /// [V]
  double voltage() const { return voltage_; }
  /// Low-pass filtered, positive while discharging [A].
  double current() const { return current_; }
  /// [Ah]
  double charge() const { return charge_; }

  void transfer(StateArchive& archive);

 private:
  static constexpr std::size_t kWindow = 100;
  double chargeOfWindow(double charge);

  Parameters parameters_;
  double voltage_ = 0;
  double current_ = 0;
  double charge_ = 0;
  double stateOfCharge_ = 1;
  /// Charge drawn in each of the last steps [Ah], the oldest at `oldest_` once the window is full.
  std::array<double, kWindow> window_{};
  std::size_t oldest_ = 0;
};

}  // namespace pongsim
