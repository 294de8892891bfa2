#include "kinematics.hh"

#include <cmath>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

// Turns below this [rad] count as straight motion.
constexpr double kStraightOn = 1e-6;

/// @return Ratio of a wheel's ground speed to the turning rate: its distances from the centre along and across, added
/// [m].
double turningLength(const MecanumGeometry& geometry) { return (geometry.wheelSeparation + geometry.wheelbase) / 2; }

}  // namespace

MecanumWheels wheelsFor(const MecanumGeometry& geometry, const PlanarTwist& twist) {
  const double turn = twist.yaw * turningLength(geometry);
  const double radius = geometry.wheelRadius;
  return {(twist.x - twist.y - turn) / radius, (twist.x + twist.y + turn) / radius, (twist.x + twist.y - turn) / radius,
          (twist.x - twist.y + turn) / radius};
}

PlanarTwist twistOf(const MecanumGeometry& geometry, const MecanumWheels& wheels) {
  const double quarter = geometry.wheelRadius / 4;
  return {
      quarter * (wheels.frontLeft + wheels.frontRight + wheels.backLeft + wheels.backRight),
      quarter * (-wheels.frontLeft + wheels.frontRight + wheels.backLeft - wheels.backRight),
      quarter * (-wheels.frontLeft + wheels.frontRight - wheels.backLeft + wheels.backRight) / turningLength(geometry)};
}

void MecanumOdometry::update(const MecanumGeometry& geometry, const MecanumWheels& angles, double dt) {
  if (!started_) last_ = angles;
  started_ = true;
  const PlanarTwist way = twistOf(geometry, {angles.frontLeft - last_.frontLeft, angles.frontRight - last_.frontRight,
                                             angles.backLeft - last_.backLeft, angles.backRight - last_.backRight});
  last_ = angles;

  // along an arc, as for constant velocities
  double forward = way.x;
  double left = way.y;
  if (std::abs(way.yaw) >= kStraightOn) {
    const double sine = math::sin(way.yaw) / way.yaw;
    const double rest = (1 - math::cos(way.yaw)) / way.yaw;
    forward = way.x * sine - way.y * rest;
    left = way.x * rest + way.y * sine;
  }
  x_ += forward * math::cos(heading_) - left * math::sin(heading_);
  y_ += forward * math::sin(heading_) + left * math::cos(heading_);
  heading_ += way.yaw;
  forward_.add(way.x / dt);
  lateral_.add(way.y / dt);
  angular_.add(way.yaw / dt);
}

void MecanumOdometry::transfer(StateArchive& archive) {
  for (double* value : {&x_, &y_, &heading_, &last_.frontLeft, &last_.frontRight, &last_.backLeft, &last_.backRight}) {
    archive(*value);
  }
  archive(started_);
  for (RollingMean<10>* mean : {&forward_, &lateral_, &angular_}) mean->transfer(archive);
}

}  // namespace pongsim
