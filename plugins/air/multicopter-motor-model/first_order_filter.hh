#pragma once

#include "pongsim/math.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim {

/// A first-order filter, x' = (u - x) / tau, with one time constant for rising and one for falling input. It is exact
/// for an input that is constant during a step.
class FirstOrderFilter {
 public:
  FirstOrderFilter() = default;
  /// @param timeUp Time constant while the input is above the value [s], zero or more; zero follows at once.
  /// @param timeDown Likewise below it.
  FirstOrderFilter(double timeUp, double timeDown) : timeUp_(timeUp), timeDown_(timeDown) {}

  /// @param dt Time since the last call [s], above zero.
  /// @return The value now.
  double update(double input, double dt) {
    // with an infinite quotient nothing of the old value is left
    const double kept = math::exp(-dt / (input > value_ ? timeUp_ : timeDown_));
    value_ = kept * value_ + (1 - kept) * input;
    return value_;
  }

  double value() const { return value_; }
  void reset() { value_ = 0; }
  void transfer(StateArchive& archive) { archive(value_); }

 private:
  double timeUp_ = 0;
  double timeDown_ = 0;
  double value_ = 0;
};

}  // namespace pongsim
