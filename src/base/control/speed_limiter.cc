#include "pongsim/control/speed_limiter.hh"

#include <algorithm>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim {

void declareSpeedLimits(Declaration& declaration, SpeedLimitParameters& parameters, std::string_view kind,
                        std::string_view unit) {
  const std::string middle = kind.empty() ? "_" : "_" + std::string(kind) + "_";
  const std::string prefix = kind.empty() ? "linear and angular " : std::string(kind) + " ";
  const auto add = [&](const std::string& quantity, const std::string& unitOfValue, std::optional<double>& min,
                       std::optional<double>& max) {
    const std::string text = " " + prefix + quantity;
    const std::string fallback = kind.empty() ? "no limit" : "the common limit";
    declaration.parameter("min" + middle + quantity, &min, unitOfValue, "minimum" + text)
        .mayBeInfinite()
        .otherwise(fallback);
    declaration.parameter("max" + middle + quantity, &max, unitOfValue, "maximum" + text)
        .mayBeInfinite()
        .otherwise(fallback);
  };
  const std::string velocity(unit);
  add("velocity", velocity, parameters.minVelocity, parameters.maxVelocity);
  add("acceleration", velocity + "^2", parameters.minAcceleration, parameters.maxAcceleration);
  add("jerk", velocity + "^3", parameters.minJerk, parameters.maxJerk);
}

SpeedLimits speedLimits(const SpeedLimitParameters& own, const SpeedLimitParameters& all, std::string_view kind,
                        const Element& plugin) {
  SpeedLimits limits;
  const auto take = [](const std::optional<double>& first, const std::optional<double>& second, double& limit) {
    limit = first.value_or(second.value_or(limit));
  };
  take(own.minVelocity, all.minVelocity, limits.minVelocity);
  take(own.maxVelocity, all.maxVelocity, limits.maxVelocity);
  take(own.minAcceleration, all.minAcceleration, limits.minAcceleration);
  take(own.maxAcceleration, all.maxAcceleration, limits.maxAcceleration);
  take(own.minJerk, all.minJerk, limits.minJerk);
  take(own.maxJerk, all.maxJerk, limits.maxJerk);
  const auto check = [&](const char* quantity, double min, double max) {
    if (min <= max) return;
    throw Error({Severity::kError,
                 plugin.position,
                 "the minimum " + std::string(kind) + " " + quantity + " is above the maximum",
                 {}});
  };
  check("velocity", limits.minVelocity, limits.maxVelocity);
  check("acceleration", limits.minAcceleration, limits.maxAcceleration);
  check("jerk", limits.minJerk, limits.maxJerk);
  return limits;
}

double SpeedLimiter::limit(double wanted, double dt) {
  double velocity = wanted;
  if (dt > 0) {
    const double lastAcceleration = (last_ - beforeLast_) / dt;
    const double jerk = ((velocity - last_) / dt - lastAcceleration) / dt;
    const double limitedJerk = std::clamp(jerk, limits_.minJerk, limits_.maxJerk);
    if (limitedJerk != jerk) velocity = last_ + (lastAcceleration + limitedJerk * dt) * dt;

    const double acceleration = (velocity - last_) / dt;
    const double limitedAcceleration = std::clamp(acceleration, limits_.minAcceleration, limits_.maxAcceleration);
    if (limitedAcceleration != acceleration) velocity = last_ + limitedAcceleration * dt;
  }
  velocity = std::clamp(velocity, limits_.minVelocity, limits_.maxVelocity);
  beforeLast_ = last_;
  last_ = velocity;
  return velocity;
}

}  // namespace pongsim
