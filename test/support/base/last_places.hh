#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "pongsim/random.hh"

namespace pongsim::math::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Range of the arguments with which a test calls a function.
struct Range {
  double low;
  double high;
  /// The arguments are 2^x and -2^x for x in the range.
  bool isOfPowers = false;
};

/// @return The error of `found` in units in the last place.
inline double lastPlaces(double found, long double exact) {
  const double size = std::max(std::abs(static_cast<double>(exact)), std::numeric_limits<double>::min());
  const double unit = std::nextafter(size, kInfinity) - size;
  return static_cast<double>(std::abs(found - exact) / unit);
}

inline double drawn(Random& random, const Range& range) {
  const double number = range.low + (range.high - range.low) * random.uniform();
  if (!range.isOfPowers) return number;
  return std::exp2(number) * (random.uniform() < 0.5 ? -1 : 1);
}

/// @param exact The same function in long double, which has eleven bits more.
/// @return The largest error for 100,000 random arguments, in units in the last place.
template <class Function, class Exact>
double worstError(Function function, Exact exact, const Range& range) {
  Random random(1, "numbers");
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double number = drawn(random, range);
    worst = std::max(worst, lastPlaces(function(number), exact(static_cast<long double>(number))));
  }
  return worst;
}

}  // namespace pongsim::math::test
