// The exponential function: the approximations of FreeBSD's msun (e_exp.c, s_expm1.c), which carry this notice:
// Copyright (C) 1993, 2004 by Sun Microsystems, Inc. All rights reserved. Permission to use, copy, modify, and
// distribute this software is freely granted, provided that this notice is preserved.

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

constexpr double kLargestPower = 7.09782712893383973096e+02, kSmallestPower = -7.45133219101941108420e+02;
constexpr double kOneByLn2 = 1.44269504088896338700e+00;
// the first part has 32 bits, so that integer multiples are exact; the second is the rest
constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;
constexpr double kHalfLn2 = 0.34657359027997264;

/// @return 2^exponent, exponent in [-1022, 1023].
double powerOf2(int exponent) {
  assert(exponent >= -1022 && exponent <= 1023);
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52U);
}

/// @return number * 2^exponent, number near 1.
double scaled(double number, int exponent) {
  if (exponent > 1023) return number * 2 * powerOf2(exponent - 1);
  if (exponent < -1021) return number * powerOf2(exponent + 1000) * 0x1p-1000;
  return number * powerOf2(exponent);
}

/// A number as exponent * ln 2 + high - low, where high - low is at most ln 2 / 2 in magnitude.
struct ReducedPower {
  explicit ReducedPower(double power) {
    if (std::abs(power) <= kHalfLn2) {
      high = power;
      return;
    }
    exponent = static_cast<int>(kOneByLn2 * power + (power < 0 ? -0.5 : 0.5));
    high = power - exponent * kLn2High;
    low = exponent * kLn2Low;
  }
  int exponent = 0;
  double high = 0;
  double low = 0;
};

}  // namespace

double exp(double power) {
  if (std::isnan(power)) return std::numeric_limits<double>::quiet_NaN();
  if (power > kLargestPower) return std::numeric_limits<double>::infinity();
  if (power < kSmallestPower) return 0;
  const ReducedPower reduced(power);
  const double x = reduced.high - reduced.low, z = x * x;
  const double c =
      x -
      z * (1.66666666666666019037e-01 +
           z * (-2.77777777770155933842e-03 +
                z * (6.61375632143793436117e-05 + z * (-1.65339022054652515390e-06 + z * 4.13813679705723846039e-08))));
  return scaled(1 + (x * c / (2 - c) - reduced.low + reduced.high), reduced.exponent);
}

double expm1(double power) {
  if (std::isnan(power)) return std::numeric_limits<double>::quiet_NaN();
  if (power > kLargestPower) return std::numeric_limits<double>::infinity();
  if (power < -56 * kLn2High) return -1;
  if (std::abs(power) < 0x1p-54) return power;
  const ReducedPower reduced(power);
  const int exponent = reduced.exponent;
  const double x = reduced.high - reduced.low, lost = (reduced.high - x) - reduced.low;
  const double half = 0.5 * x, z = x * half;
  const double r =
      1 +
      z * (-3.33333333333331316428e-02 +
           z * (1.58730158725481460165e-03 + z * (-7.93650757867487942473e-05 +
                                                  z * (4.00821782732936239552e-06 + z * -2.01099218183624371326e-07))));
  const double t = 3 - r * half;
  const double e = z * ((r - t) / (6 - x * t));
  if (exponent == 0) return x - (x * e - z);
  // e^x = 1 + x - correction
  const double correction = x * (e - lost) - lost - z;
  if (exponent == -1) return 0.5 * (x - correction) - 0.5;
  if (exponent == 1) return x < -0.25 ? -2 * (correction - (x + 0.5)) : 1 + 2 * (x - correction);
  // subtract 1 where that loses no digits
  if (exponent < 0 || exponent > 56) return scaled(x - correction + 1, exponent) - 1;
  const double one = powerOf2(-exponent);
  return (exponent < 20 ? x - correction + (1 - one) : x - (correction + one) + 1) * powerOf2(exponent);
}

}  // namespace pongsim::math
