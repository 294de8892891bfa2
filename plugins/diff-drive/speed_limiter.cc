#include "speed_limiter.hh"

#include <algorithm>

namespace pongsim {

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
