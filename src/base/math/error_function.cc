#include <cmath>
#include <limits>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

// Abramowitz and Stegun, Handbook of Mathematical Functions (1964)

/// @return erf(x), by 7.1.6, whose terms are all positive.
double byItsSeries(double x) {
  double term = x, sum = x;
  for (int n = 1; term > sum * 1e-17; ++n) {
    term *= 2 * x * x / (2 * n + 1);
    sum += term;
  }
  return 2 * std::numbers::inv_sqrtpi * exp(-x * x) * sum;
}

/// @return erfc(x), by 7.1.14; from 1.5 on this many terms are enough.
double byItsFraction(double x) {
  constexpr int kTerms = 120;
  double rest = x;
  for (int n = kTerms; n > 0; --n) rest = x + n / (2 * rest);
  return std::numbers::inv_sqrtpi * exp(-x * x) / rest;
}

}  // namespace

double erfc(double number) {
  if (std::isnan(number)) return std::numeric_limits<double>::quiet_NaN();
  const double size = std::abs(number);
  // from 27 on it underflows
  const double above = size < 1.5 ? 1 - byItsSeries(size) : size < 27.5 ? byItsFraction(size) : 0;
  return number < 0 ? 2 - above : above;
}

}  // namespace pongsim::math
