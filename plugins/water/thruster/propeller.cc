#include "propeller.hh"

#include <cmath>
#include <limits>

#include "pongsim/math.hh"

namespace pongsim {

double Propeller::turnFor(double thrust) {
  // a propeller at rest has no advance ratio, so it starts with some speed
  if (!settings_.coefficient && std::abs(speed_) > std::numeric_limits<double>::epsilon()) {
    const double waterSpeed = (1 - settings_.wakeFraction) * craftSpeed_;
    const double coefficient = settings_.alpha1 + settings_.alpha2 * waterSpeed / (speed_ * settings_.diameter);
    // keep the last one otherwise: with a coefficient of zero, no speed gives thrust
    if (std::abs(coefficient) > std::numeric_limits<double>::epsilon()) coefficient_ = coefficient;
  }
  speed_ = speedFor(thrust);
  return speed_;
}

double Propeller::thrustPerSquare() const {
  const double square = settings_.diameter * settings_.diameter;
  return settings_.density * coefficient_ * square * square;
}

double Propeller::speedFor(double thrust) const {
  const double square = thrust / thrustPerSquare();
  return std::copysign(std::sqrt(std::abs(square)), square);
}

double Propeller::thrustAt(double speed) const { return thrustPerSquare() * std::abs(speed) * speed; }

}  // namespace pongsim
