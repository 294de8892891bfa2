#include "geometry.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

// Slower turns [rad/s] count as straight motion.
constexpr double kNoTurn = 0.001;
// Radius of straight motion [m].
constexpr double kStraight = 1e9;

/// @return Radius of the turn [m], negative to the right.
double turningRadius(const AckermannGeometry& geometry, double linear, double angular) {
  if (std::abs(angular) < kNoTurn) return kStraight;
  const double narrowest = geometry.wheelBase / math::sin(geometry.steeringLimit);
  if (linear == 0) return std::copysign(narrowest, angular);
  const double radius = linear / angular;
  return std::abs(radius) < narrowest ? std::copysign(narrowest, radius) : radius;
}

}  // namespace

AckermannCommand ackermannCommand(const AckermannGeometry& geometry, double linear, double angular) {
  const double radius = turningRadius(geometry, linear, angular);
  AckermannCommand command;
  command.leftAngle = math::atan(geometry.wheelBase / (radius - geometry.kingpinWidth / 2));
  command.rightAngle = math::atan(geometry.wheelBase / (radius + geometry.kingpinWidth / 2));
  // the outer wheels have a longer path
  const double difference = geometry.wheelSeparation / (2 * radius);
  command.leftSpeed = linear * (1 - difference) / geometry.wheelRadius;
  command.rightSpeed = linear * (1 + difference) / geometry.wheelRadius;
  return command;
}

AckermannCommand ackermannAngles(const AckermannGeometry& geometry, double angle) {
  const auto [sine, cosine] = math::sinCos(std::clamp(angle, -geometry.steeringLimit, geometry.steeringLimit));
  AckermannCommand command;
  command.leftAngle =
      math::atan(2 * geometry.wheelBase * sine / (2 * geometry.wheelBase * cosine - geometry.wheelSeparation * sine));
  command.rightAngle =
      math::atan(2 * geometry.wheelBase * sine / (2 * geometry.wheelBase * cosine + geometry.wheelSeparation * sine));
  return command;
}

void AckermannOdometry::update(const AckermannGeometry& geometry, double leftAngle, double rightAngle, double steering,
                               double dt) {
  if (!started_) {
    lastLeft_ = leftAngle;
    lastRight_ = rightAngle;
    started_ = true;
  }
  const double way = geometry.wheelRadius * (leftAngle - lastLeft_ + rightAngle - lastRight_) / 2;
  lastLeft_ = leftAngle;
  lastRight_ = rightAngle;
  const double turn = way * math::tan(steering) / geometry.wheelBase;
  value_.heading = std::remainder(value_.heading + turn, 2 * std::numbers::pi);
  value_.x += way * math::cos(value_.heading);
  value_.y += way * math::sin(value_.heading);
  value_.linearVelocity = way / dt;
  value_.angularVelocity = turn / dt;
}

void AckermannOdometry::transfer(StateArchive& archive) {
  for (double* value : {&value_.x, &value_.y, &value_.heading, &value_.linearVelocity, &value_.angularVelocity,
                        &lastLeft_, &lastRight_}) {
    archive(*value);
  }
  archive(started_);
}

}  // namespace pongsim
