#pragma once

#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/export.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// Gains and limits of a PID controller. A pair of limits has no effect if its upper limit is below the lower.
struct PidSettings {
  double p = 0;
  double i = 0;
  double d = 0;
  /// Limits of the integral term, including its gain.
  double iMin = 0;
  double iMax = -1;
  double commandMin = 0;
  double commandMax = -1;
  double commandOffset = 0;
};

/// Adds the parameters `<p_gain>`, `<i_gain>`, `<d_gain>`, `<i_min>`, `<i_max>`, `<cmd_min>`, `<cmd_max>` and
/// `<cmd_offset>`, each with `prefix` before its name. The values in `settings` are the defaults.
/// @param unit Unit of the command: "N m".
PONGSIM_API void declarePid(Declaration& declaration, PidSettings& settings, std::string_view unit,
                            std::string_view prefix = {});

/// PID controller, like ignition-math's PID.
class PONGSIM_API Pid {
 public:
  explicit Pid(const PidSettings& settings = {}) : settings_(settings) {}

  /// @param error Actual value minus desired value.
  /// @param dt Time since the last call [s].
  /// @return The command; zero if `dt` is not above zero or the error is not finite.
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
