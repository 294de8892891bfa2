#pragma once

#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/export.hh"
#include "pongsim/state_archive.hh"

namespace pongsim {

/// Gains and bounds of a controller. A pair of bounds whose larger one is below the smaller one bounds nothing.
struct PidSettings {
  double p = 0;
  double i = 0;
  double d = 0;
  /// Bounds of the integral term, its gain included.
  double iMin = 0;
  double iMax = -1;
  double commandMin = 0;
  double commandMax = -1;
  double commandOffset = 0;
};

/// Adds the parameters `<p_gain>`, `<i_gain>`, `<d_gain>`, `<i_min>`, `<i_max>`, `<cmd_min>`, `<cmd_max>` and
/// `<cmd_offset>`, each with `prefix` before its name. What stands in `settings` is the default.
/// @param unit Of the command: "N m".
PONGSIM_API void declarePid(Declaration& declaration, PidSettings& settings, std::string_view unit,
                            std::string_view prefix = {});

/// A controller with a proportional, an integral and a derivative term, as ignition-math's PID.
class PONGSIM_API Pid {
 public:
  explicit Pid(const PidSettings& settings = {}) : settings_(settings) {}

  /// @param error What is less what should be.
  /// @param dt Time since the last call [s].
  /// @return The command that takes the error back; zero where `dt` is not above zero or the error is not finite.
  double update(double error, double dt);

  void reset() {
    integral_ = 0;
    lastError_ = 0;
  }

  void transfer(StateArchive& archive) {
    archive(integral_);
    archive(lastError_);
  }

 private:
  PidSettings settings_;
  double integral_ = 0;
  double lastError_ = 0;
};

}  // namespace pongsim
