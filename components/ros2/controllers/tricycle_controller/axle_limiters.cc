#include "ros2/controllers/tricycle_controller/axle_limiters.hh"

#include <algorithm>
#include <cmath>

namespace pongsim::ros2 {

namespace {
constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
// tricycle_controller's
constexpr double kLargestMagnitude = 1000;
}  // namespace

MagnitudeRange MagnitudeRange::read(ControllerParameters& parameters, const std::string& prefix,
                                    const std::string& name) {
  MagnitudeRange range{parameters.number(prefix + "min_" + name, kUnset),
                       parameters.number(prefix + "max_" + name, kUnset)};
  if (std::isnan(range.least) && !std::isnan(range.most)) range.least = 0;
  if (std::isnan(range.most) && !std::isnan(range.least)) range.most = kLargestMagnitude;
  if (range.least < 0 || range.most < 0) parameters.complain("'" + prefix + "..." + name + "' must not be below zero");
  if (range.least > range.most) {
    parameters.complain("'" + prefix + "min_" + name + "' is above '" + prefix + "max_" + name + "'");
  }
  return range;
}

double MagnitudeRange::limit(double value) const {
  if (std::isnan(most)) return value;
  return std::copysign(std::clamp(std::abs(value), least, most), value);
}

TractionLimiter TractionLimiter::read(ControllerParameters& parameters) {
  const auto range = [&](const char* name) { return MagnitudeRange::read(parameters, "traction.", name); };
  return {range("velocity"), range("acceleration"), range("deceleration"), range("jerk")};
}

double TractionLimiter::limit(double wanted, double last, double beforeLast, double dt) const {
  double speed = wanted;
  const auto scaled = [](const MagnitudeRange& range, double by, double value) {
    return MagnitudeRange{range.least * by, range.most * by}.limit(value);
  };
  const double lastChange = last - beforeLast;
  if (!std::isnan(jerk.most)) speed = last + lastChange + scaled(jerk, 2 * dt * dt, speed - last - lastChange);
  const MagnitudeRange& change = std::abs(speed) >= std::abs(last) ? acceleration : deceleration;
  speed = last + scaled(change, dt, speed - last);
  return velocity.limit(speed);
}

SteeringLimiter SteeringLimiter::read(ControllerParameters& parameters) {
  SteeringLimiter limiter;
  limiter.leastPosition = parameters.number("steering.min_position", kUnset);
  limiter.mostPosition = parameters.number("steering.max_position", kUnset);
  if (std::isnan(limiter.leastPosition)) limiter.leastPosition = -limiter.mostPosition;
  if (std::isnan(limiter.mostPosition)) limiter.mostPosition = -limiter.leastPosition;
  if (limiter.leastPosition > limiter.mostPosition) {
    parameters.complain("'steering.min_position' is above 'steering.max_position'");
  }
  limiter.velocity = MagnitudeRange::read(parameters, "steering.", "velocity");
  limiter.acceleration = MagnitudeRange::read(parameters, "steering.", "acceleration");
  return limiter;
}

double SteeringLimiter::limit(double wanted, double last, double beforeLast, double dt) const {
  double angle = wanted;
  const double lastChange = last - beforeLast, scale = 2 * dt * dt;
  if (!std::isnan(acceleration.most)) {
    angle = last + lastChange +
            MagnitudeRange{acceleration.least * scale, acceleration.most * scale}.limit(angle - last - lastChange);
  }
  angle = last + MagnitudeRange{velocity.least * dt, velocity.most * dt}.limit(angle - last);
  return std::isnan(mostPosition) ? angle : std::clamp(angle, leastPosition, mostPosition);
}

}  // namespace pongsim::ros2
