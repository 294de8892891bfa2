#include "pongsim/control/pid.hh"

#include <algorithm>
#include <cmath>
#include <string>

namespace pongsim {

namespace {

double clampIfBounded(double value, double min, double max) { return max < min ? value : std::clamp(value, min, max); }

}  // namespace

void declarePid(Declaration& declaration, PidSettings& settings, std::string_view unit, std::string_view prefix) {
  const std::string before(prefix), ofCommand(unit);
  const auto add = [&](const char* name, double& value, const std::string& unitOfValue, const char* text) {
    declaration.parameter(before + name, &value, unitOfValue, text);
  };
  add("p_gain", settings.p, "", "proportional gain");
  add("i_gain", settings.i, "", "integral gain");
  add("d_gain", settings.d, "", "derivative gain");
  add("i_min", settings.iMin, ofCommand, "minimum integral term; no bounds if it is above `i_max`");
  add("i_max", settings.iMax, ofCommand, "maximum integral term");
  add("cmd_min", settings.commandMin, ofCommand, "minimum command; no bounds if it is above `cmd_max`");
  add("cmd_max", settings.commandMax, ofCommand, "maximum command");
  add("cmd_offset", settings.commandOffset, ofCommand, "added to the command");
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
