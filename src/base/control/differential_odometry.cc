#include "pongsim/control/differential_odometry.hh"

#include <cmath>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

// Below this rotation [rad], a step counts as straight.
constexpr double kStraightAhead = 1e-6;

}  // namespace

void DifferentialOdometry::update(double leftAngle, double rightAngle, double dt) {
  if (!started_) {
    lastLeft_ = leftAngle;
    lastRight_ = rightAngle;
    started_ = true;
  }
  const double left = (leftAngle - lastLeft_) * radius_;
  const double right = (rightAngle - lastRight_) * radius_;
  lastLeft_ = leftAngle;
  lastRight_ = rightAngle;

  const double forward = (right + left) / 2;
  const double turn = (right - left) / separation_;
  if (std::abs(turn) < kStraightAhead) {
    x_ += forward * math::cos(heading_ + turn / 2);
    y_ += forward * math::sin(heading_ + turn / 2);
    heading_ += turn;
  } else {
    const double radius = forward / turn;
    const double before = heading_;
    heading_ += turn;
    x_ += radius * (math::sin(heading_) - math::sin(before));
    y_ -= radius * (math::cos(heading_) - math::cos(before));
  }
  linear_.add(forward / dt);
  angular_.add(turn / dt);
}

void DifferentialOdometry::transfer(StateArchive& archive) {
  for (double* value : {&x_, &y_, &heading_, &lastLeft_, &lastRight_}) archive(*value);
  archive(started_);
  linear_.transfer(archive);
  angular_.transfer(archive);
}

}  // namespace pongsim
