#include "pongsim/pid.hh"

#include <algorithm>
#include <cmath>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim {

namespace {

double clampIfBounded(double value, double min, double max) { return max < min ? value : std::clamp(value, min, max); }

}  // namespace

PidSettings readPidSettings(const Element& sdf, const PidSettings& defaults, std::string_view prefix) {
  const auto read = [&](const char* name, double fallback) {
    const std::string full = std::string(prefix) + name;
    const double value = sdf.get(full, fallback);
    if (std::isfinite(value)) return value;
    throw Error({Severity::kError, sdf.child(full)->position, "<" + full + "> must be a finite number", {}});
  };
  PidSettings settings;
  settings.p = read("p_gain", defaults.p);
  settings.i = read("i_gain", defaults.i);
  settings.d = read("d_gain", defaults.d);
  settings.iMin = read("i_min", defaults.iMin);
  settings.iMax = read("i_max", defaults.iMax);
  settings.commandMin = read("cmd_min", defaults.commandMin);
  settings.commandMax = read("cmd_max", defaults.commandMax);
  settings.commandOffset = read("cmd_offset", defaults.commandOffset);
  return settings;
}

double Pid::update(double error, double dt) {
  if (!(dt > 0) || !std::isfinite(error)) return 0;
  integral_ = clampIfBounded(integral_ + settings_.i * dt * error, settings_.iMin, settings_.iMax);
  const double derivative = (error - lastError_) / dt;
  lastError_ = error;
  const double command = settings_.commandOffset - settings_.p * error - integral_ - settings_.d * derivative;
  return clampIfBounded(command, settings_.commandMin, settings_.commandMax);
}

}  // namespace pongsim
