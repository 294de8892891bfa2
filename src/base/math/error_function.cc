#include <cmath>
#include <limits>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

// Abramowitz and Stegun, Handbook of Mathematical Functions (1964)

/// @return erf(x), by the series 7.1.6. All its terms are positive, so none cancel.
double erfBySeries(double x) {
  double term = x, sum = x;
  for (int n = 1; term > sum * 1e-17; ++n) {
    term *= 2 * x * x / (2 * n + 1);
    sum += term;
  }
  return 2 * std::numbers::inv_sqrtpi * exp(-x * x) * sum;
}

/// @return erfc(x), by the continued fraction 7.1.14. From x = 1.5 on, kTerms are enough for all digits.
double erfcByFraction(double x) {
  constexpr int kTerms = 120;
  double rest = x;
  for (int n = kTerms; n > 0; --n) rest = x + n / (2 * rest);
  return std::numbers::inv_sqrtpi * exp(-x * x) / rest;
}

}  // namespace

double erfc(double number) {
  if (std::isnan(number)) return std::numeric_limits<double>::quiet_NaN();
  const double size = std::abs(number);
  // erfc underflows from about 27 on
  const double above = size < 1.5 ? 1 - erfBySeries(size) : size < 27.5 ? erfcByFraction(size) : 0;
  return number < 0 ? 2 - above : above;
}

}  // namespace pongsim::math
