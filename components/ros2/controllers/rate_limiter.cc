#include "ros2/controllers/rate_limiter.hh"

#include <algorithm>
#include <cmath>

namespace pongsim::ros2 {

namespace {

double either(double first, double second) { return std::isnan(first) ? second : first; }

}  // namespace

RateLimits RateLimits::read(ControllerParameters& parameters, const std::string& prefix) {
  const auto number = [&](const char* name) { return parameters.number(prefix + "." + name, kNone); };
  // Humble's switches
  const auto has = [&](const char* name) {
    const std::string parameter = prefix + ".has_" + name + "_limits";
    return !parameters.has(parameter) || parameters.flag(parameter, true);
  };
  RateLimits limits;
  limits.maxVelocity = number("max_velocity");
  limits.minVelocity = number("min_velocity");
  limits.maxAcceleration = number("max_acceleration");
  limits.minAcceleration = number("max_acceleration_reverse");
  limits.minDeceleration = number("max_deceleration");
  limits.maxDeceleration = number("max_deceleration_reverse");
  // Humble's name for the limit of what reduces the velocity
  if (parameters.has(prefix + ".min_acceleration")) {
    limits.minAcceleration = either(limits.minAcceleration, number("min_acceleration"));
  }
  limits.maxJerk = number("max_jerk");
  limits.minJerk = number("min_jerk");
  if (!has("velocity")) limits.minVelocity = limits.maxVelocity = kNone;
  if (!has("acceleration")) {
    limits.minAcceleration = limits.maxAcceleration = limits.minDeceleration = limits.maxDeceleration = kNone;
  }
  if (!has("jerk")) limits.minJerk = limits.maxJerk = kNone;
  const auto check = [&](double low, double high, const char* kind) {
    if (either(low, -high) > high)
      parameters.complain("'" + prefix + "': the lower limit of its " + kind + " is above the upper");
  };
  check(limits.minVelocity, limits.maxVelocity, "velocity");
  check(limits.minAcceleration, limits.maxAcceleration, "acceleration");
  check(limits.minJerk, limits.maxJerk, "jerk");
  return limits;
}

RateLimiter::RateLimiter(const RateLimits& limits) : limits_(limits) {
  limits_.minVelocity = either(limits_.minVelocity, -limits_.maxVelocity);
  limits_.minAcceleration = either(limits_.minAcceleration, -limits_.maxAcceleration);
  limits_.minDeceleration = either(limits_.minDeceleration, limits_.minAcceleration);
  limits_.maxDeceleration = either(limits_.maxDeceleration, limits_.maxAcceleration);
  limits_.minJerk = either(limits_.minJerk, -limits_.maxJerk);
}

double RateLimiter::limit(double wanted, double last, double beforeLast, double dt) const {
  double velocity = wanted;
  // jerk only where the speed grows: a limit while braking would overshoot
  const double change = velocity - last, lastChange = last - beforeLast;
  if (!std::isnan(limits_.maxJerk) && (change - lastChange) * change > 0) {
    velocity =
        last + lastChange + std::clamp(change - lastChange, limits_.minJerk * dt * dt, limits_.maxJerk * dt * dt);
  }
  if (!std::isnan(limits_.maxAcceleration)) {
    const double least = last > 0 ? limits_.minDeceleration : limits_.minAcceleration;
    const double most = last < 0 ? limits_.maxDeceleration : limits_.maxAcceleration;
    velocity = last + std::clamp(velocity - last, least * dt, most * dt);
  }
  if (!std::isnan(limits_.maxVelocity)) velocity = std::clamp(velocity, limits_.minVelocity, limits_.maxVelocity);
  return velocity;
}

}  // namespace pongsim::ros2
