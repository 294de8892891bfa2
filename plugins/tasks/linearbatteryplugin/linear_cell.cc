#include "linear_cell.hh"

#include <algorithm>
#include <cmath>

namespace pongsim {

namespace {

constexpr double kSecondsPerHour = 3600;
/// Below this voltage a battery is empty [V].
constexpr double kNoVoltage = 1e-3;
/// Charging stops at this state of charge.
constexpr double kChargedTo = 0.9;

}  // namespace

void LinearCell::reset() {
  voltage_ = parameters_.voltage;
  current_ = 0;
  charge_ = parameters_.initialCharge;
  stateOfCharge_ = charge_ / parameters_.capacity;
  window_.fill(0);
  oldest_ = 0;
}

void LinearCell::update(double dt, double load, bool isCharging) {
  const bool isDead = std::abs(voltage_) < kNoVoltage;
  if (!isCharging && isDead) voltage_ = 0;
  if (!isCharging && (isDead || stateOfCharge_ < 0)) return;

  double wanted = isDead ? 0 : load / voltage_;
  if (isCharging && stateOfCharge_ < kChargedTo) wanted -= parameters_.capacity / parameters_.chargingTime;
  // a filter cannot be faster than a step
  current_ += dt / std::max(parameters_.smoothing, dt) * (wanted - current_);

  const double taken = dt * current_ / kSecondsPerHour;
  charge_ -= taken;
  voltage_ = parameters_.constantVoltage + parameters_.linearVoltage * (1 - charge_ / parameters_.capacity) -
             parameters_.resistance * current_;
  if (parameters_.countsOnce) {
    stateOfCharge_ = charge_ / parameters_.capacity;
  } else {
    stateOfCharge_ -= chargeOfWindow(taken) / parameters_.capacity;
  }
}

double LinearCell::chargeOfWindow(double charge) {
  window_[oldest_] = charge;
  oldest_ = (oldest_ + 1) % kWindow;
  double sum = 0;
  for (std::size_t i = 0; i < kWindow; ++i) sum += window_[(oldest_ + i) % kWindow];
  return sum;
}

void LinearCell::transfer(StateArchive& archive) {
  for (double* value : {&voltage_, &current_, &charge_, &stateOfCharge_}) archive(*value);
  for (double& value : window_) archive(value);
  archive(oldest_);
  archive.check(oldest_ < kWindow);
}

}  // namespace pongsim
