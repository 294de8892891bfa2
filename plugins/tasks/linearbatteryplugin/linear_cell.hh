#pragma once

#include <array>
#include <cstddef>

#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A battery whose open-circuit voltage falls in a straight line with its charge: V = e0 + e1 (1 - q/c) - r i, with the
/// charge q, the capacity c, the inner resistance r and the current i, which follows P/V by a low pass.
class LinearCell {
 public:
  struct Parameters {
    /// At the start [V].
    double voltage = 0;
    /// e0: of the full battery without load [V].
    double constantVoltage = 0;
    /// e1: how much that changes until the battery is empty, most often below zero [V].
    double linearVoltage = 0;
    /// [Ah], above 0.
    double capacity = 1;
    /// [Ah]
    double initialCharge = 1;
    /// [Ohm]
    double resistance = 0;
    /// Time constant of the current [s], above 0.
    double smoothing = 1;
    /// What an empty battery takes to be full [h], above 0.
    double chargingTime = 1;
    /// The state of charge is q/c. Without it, it falls by the last hundred steps' charge in each step, as Fortress has
    /// it by default (its issue 225): about a hundred times too fast.
    bool countsOnce = false;
  };

  explicit LinearCell(const Parameters& parameters) : parameters_(parameters) { reset(); }

  void reset();

  /// Goes on by `dt` [s].
  /// @param load What is taken from it [W].
  void update(double dt, double load, bool isCharging);

  /// @return State of charge, 1: full; below zero where it is empty.
  double stateOfCharge() const { return stateOfCharge_; }
  /// [V]
  double voltage() const { return voltage_; }
  /// Smoothed, above zero where it drains [A].
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
  /// What was taken in each of the last steps [Ah], the oldest at `oldest_` once all are there.
  std::array<double, kWindow> window_{};
  std::size_t oldest_ = 0;
};

}  // namespace pongsim
