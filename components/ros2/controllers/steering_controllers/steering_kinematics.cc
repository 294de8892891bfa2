#include "ros2/controllers/steering_controllers/steering_kinematics.hh"

#include <cmath>

#include "pongsim/math.hh"

namespace pongsim::ros2 {

namespace {
constexpr double kStraight = 1e-6;
}

double SteeringKinematics::steeringAngle(double linear, double angular) const {
  const double angle = math::atan(angular * wheelbase / linear);
  // nothing moves
  return std::isfinite(angle) ? angle : 0;
}

SteeringKinematics::Wheels SteeringKinematics::commands(double linear, double angular, double turnAngle) const {
  const double speed = linear / wheelRadius, angle = steeringAngle(linear, angular);
  Wheels wheels;
  const bool isStraight = std::abs(turnAngle) < kStraight;
  if (tractionWheels == 1 || isStraight) {
    wheels.speeds.assign(static_cast<std::size_t>(tractionWheels), speed);
  } else {
    const double radius = wheelbase / math::tan(turnAngle);
    wheels.speeds = {speed * (radius + tractionTrack / 2) / radius, speed * (radius - tractionTrack / 2) / radius};
  }
  if (steeredWheels == 1 || isStraight) {
    wheels.angles.assign(static_cast<std::size_t>(steeredWheels), angle);
  } else {
    const auto [sine, cosine] = math::sinCos(angle);
    const double along = 2 * wheelbase * sine, across = 2 * wheelbase * cosine, half = steeringTrack * sine;
    wheels.angles = {math::atan2(along, across + half), math::atan2(along, across - half)};
  }
  return wheels;
}

double SteeringKinematics::steeringAngle(const std::vector<double>& angles) const {
  if (angles.size() == 1) return angles[0];
  const auto middle = [this](double angle, double side) {
    const double tangent = math::tan(angle);
    return math::atan(wheelbase * tangent / (wheelbase - side * steeringTrack / 2 * tangent));
  };
  return (middle(angles[0], 1) + middle(angles[1], -1)) / 2;
}

double SteeringKinematics::linearVelocity(const std::vector<double>& speeds, double steeringAngle) const {
  if (speeds.size() == 1) return speeds[0] * wheelRadius;
  const double right = speeds[0] * wheelRadius, left = speeds[1] * wheelRadius;
  const double radius = wheelbase / math::tan(steeringAngle);
  if (std::isinf(radius)) return (right + left) / 2;
  return (right * radius / (radius + tractionTrack / 2) + left * radius / (radius - tractionTrack / 2)) / 2;
}

double SteeringKinematics::angularVelocity(double linear, double steeringAngle) const {
  return math::tan(steeringAngle) * linear / wheelbase;
}

}  // namespace pongsim::ros2
