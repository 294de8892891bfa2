#include <algorithm>
#include <cmath>
#include <limits>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

/// A square in two parts: the nearest double, and its rounding error.
struct Square {
  // Dekker, A floating-point technique for extending the available precision, Numerische Mathematik 18 (1971)
  explicit Square(double root) : value(root * root) {
    const double scaled = root * 0x1.0000002p27;
    const double high = scaled - (scaled - root), low = root - high;
    rest = ((high * high - value) + 2 * high * low) + low * low;
  }
  double value;
  double rest;
};

}  // namespace

double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  double large = std::max(std::abs(x), std::abs(y)), small = std::min(std::abs(x), std::abs(y));
  if (small == 0 || large * 0x1p-60 >= small) return large + small;
  // for squares that overflow or underflow
  double scale = 1;
  if (large > 0x1p500) scale = 0x1p600;
  if (small < 0x1p-450) scale = 0x1p-600;
  large /= scale;
  small /= scale;
  const Square a(large), b(small);
  return scale * std::sqrt(b.rest + a.rest + b.value + a.value);
}

}  // namespace pongsim::math
