#include "ros2/controllers/wheel_odometry.hh"

#include <cmath>

#include "pongsim/math.hh"

namespace pongsim::ros2 {

void WindowMean::add(double value) {
  if (values_.size() < size_) {
    values_.push_back(value);
  } else {
    values_[next_] = value;
  }
  next_ = (next_ + 1) % size_;
}

double WindowMean::mean() const {
  double sum = 0;
  for (const double value : values_) sum += value;
  return values_.empty() ? 0 : sum / static_cast<double>(values_.size());
}

void WindowMean::transfer(StateArchive& archive) {
  archive(next_);
  archive(values_);
  archive.check(next_ < size_ && values_.size() <= size_);
}

void WheelOdometry::advance(double linear, double angular, double dt) {
  const double distance = linear * dt, turn = angular * dt;
  if (std::abs(turn) < 1e-6) {
    const auto [sine, cosine] = math::sinCos(heading_ + turn / 2);
    x_ += distance * cosine;
    y_ += distance * sine;
    heading_ += turn;
    return;
  }
  const auto before = math::sinCos(heading_);
  heading_ += turn;
  const auto after = math::sinCos(heading_);
  x_ += distance / turn * (after.sine - before.sine);
  y_ -= distance / turn * (after.cosine - before.cosine);
}

void WheelOdometry::advanceStraight(double linear, double lateral, double angular, double dt) {
  heading_ += angular * dt;
  const auto [sine, cosine] = math::sinCos(heading_);
  x_ += (cosine * linear - sine * lateral) * dt;
  y_ += (sine * linear + cosine * lateral) * dt;
}

void WheelOdometry::setVelocities(double linear, double lateral, double angular) {
  linearVelocity_ = linear;
  lateralVelocity_ = lateral;
  angularVelocity_ = angular;
}

void WheelOdometry::average(double linear, double angular) {
  linear_.add(linear);
  angular_.add(angular);
  setVelocities(linear_.mean(), 0, angular_.mean());
}

void WheelOdometry::reset() {
  x_ = y_ = heading_ = 0;
  setVelocities(0, 0, 0);
  linear_.clear();
  angular_.clear();
}

void WheelOdometry::transfer(StateArchive& archive) {
  for (double* value : {&x_, &y_, &heading_, &linearVelocity_, &lateralVelocity_, &angularVelocity_}) archive(*value);
  archive(linear_);
  archive(angular_);
}

}  // namespace pongsim::ros2
