// The natural logarithm: the approximation of FreeBSD's msun (e_log.c, s_log1p.c), which carry this notice: Copyright
// (C) 1993 by Sun Microsystems, Inc. All rights reserved. Permission to use, copy, modify, and distribute this software
// is freely granted, provided that this notice is preserved.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoLogarithm = std::numeric_limits<double>::quiet_NaN();
// ln 2 in two parts; the first has few enough bits to make integer multiples exact
constexpr double kLn2Most = 6.93147180369123816490e-01, kLn2Rest = 1.90821492927058770002e-10;
constexpr double kRootOf2 = 1.4142135623730951;

/// A number as 2^exponent * (1 + fraction), with 1 + fraction between the square roots of 1/2 and 2.
struct Split {
  /// @param number Positive, not subnormal.
  explicit Split(double number) {
    // numbers above the square root of 1/2 count towards the next power of 2
    constexpr std::uint64_t kToOne = 0x3ff0000000000000U - 0x3fe6a09e00000000U;
    const std::uint64_t moved = std::bit_cast<std::uint64_t>(number) + kToOne;
    exponent = static_cast<int>(moved >> 52U) - 1023;
    fraction = std::bit_cast<double>((moved & 0xfffffffffffffU) + 0x3fe6a09e00000000U) - 1;
  }
  int exponent;
  double fraction;
};

/// @return exponent * ln 2 + log(1 + fraction) + correction, where the correction is small in comparison.
double logarithmOf(int exponent, double fraction, double correction) {
  const double square = 0.5 * fraction * fraction;
  const double s = fraction / (2 + fraction), z = s * s, w = z * z;
  const double odd = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const double even =
      z * (6.666666666666735130e-01 +
           w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  return s * (square + (even + odd)) + (exponent * kLn2Rest + correction) - square + fraction + exponent * kLn2Most;
}

}  // namespace

double log(double number) {
  if (number == 0) return -kInfinity;
  if (!(number > 0)) return kNoLogarithm;
  if (number == kInfinity) return kInfinity;
  const bool isSubnormal = number < std::numeric_limits<double>::min();
  const Split split(isSubnormal ? number * 0x1p54 : number);
  return logarithmOf(split.exponent - (isSubnormal ? 54 : 0), split.fraction, 0);
}

double log1p(double number) {
  if (number == -1) return -kInfinity;
  if (!(number > -1)) return kNoLogarithm;
  if (number == kInfinity) return kInfinity;
  if (std::abs(number) < 0x1p-53) return number;
  if (number > kRootOf2 / 2 - 1 && number < kRootOf2 - 1) return logarithmOf(0, number, 0);
  // correct for the rounding error of the sum: log(s + d) is nearly log(s) + d / s
  const double sum = 1 + number;
  const double lost = number > 1 ? 1 - (sum - number) : number - (sum - 1);
  const Split split(sum);
  return logarithmOf(split.exponent, split.fraction, split.exponent < 54 ? lost / sum : 0);
}

}  // namespace pongsim::math
