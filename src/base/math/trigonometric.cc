// Sine, cosine and tangent: the polynomials of FreeBSD's msun (k_sin.c, k_cos.c, k_tan.c) with their order of
// summation, which carry this notice: Copyright (C) 1993, 2004 by Sun Microsystems, Inc. All rights reserved.
// Permission to use, copy, modify, and distribute this software is freely granted, provided that this notice is
// preserved.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/math/angle_reduction.hh"
#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

constexpr double kQuarterPi = 0x1.921fb54442d18p-1, kQuarterPiLow = 0x1.1a62633145c07p-55;
constexpr double kNoAngle = std::numeric_limits<double>::quiet_NaN();
// below this, sine and tangent equal the angle; this also preserves -0
constexpr double kTinyAngle = 0x1p-27;
// from here on, tan(x) is computed from tan(pi/4 - x)
constexpr double kSteep = 0.6744;

/// @return The sine of x + tail, |x| up to pi/4.
double sineNear0(double x, double tail) {
  const double z = x * x, w = z * z, v = z * x;
  const double r = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06) +
                   z * w * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10);
  return x - ((z * (0.5 * tail - v * r) - tail) - v * -1.66666666666666324348e-01);
}

/// @return The cosine of x + tail, |x| up to pi/4.
double cosineNear0(double x, double tail) {
  const double z = x * x, w = z * z;
  const double r =
      z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * 2.48015872894767294178e-05)) +
      w * w * (-2.75573143513506633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));
  const double half = 0.5 * z, one = 1 - half;
  return one + (((1 - one) - half) + (z * r - x * tail));
}

/// @return The number with the lower 32 of its 52 fraction bits cleared.
double upperHalf(double number) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) & 0xffffffff00000000U);
}

/// @return tan(x + tail) - x for x below kSteep, by an odd polynomial.
double tangentExcess(double x, double tail) {
  const double z = x * x, w = z * z;
  const double odd =
      1.33333333333201242699e-01 +
      w * (2.18694882948595424599e-02 +
           w * (3.59207910759131235356e-03 +
                w * (5.88041240820264096874e-04 + w * (7.81794442939557092300e-05 + w * -1.85586374855275456654e-05))));
  const double even = z * (5.39682539762260521377e-02 +
                           w * (8.86323982359930005737e-03 +
                                w * (1.45620945432529025516e-03 +
                                     w * (2.46463134818469906812e-04 +
                                          w * (7.14072491382608190305e-05 + w * 2.59073051863633712884e-05)))));
  const double s = z * x;
  return tail + z * (s * (odd + even) + tail) + s * 3.33333333333334091986e-01;
}

/// @return tan(x + tail), |x| up to pi/4; if `isTurned`, -1 / tan(x + tail), which is the tangent a quarter turn
/// further.
double tangentNear0(double x, double tail, bool isTurned) {
  if (std::abs(x) >= kSteep) {
    const double sign = x < 0 ? -1 : 1;
    const double rest = (kQuarterPi - sign * x) + (kQuarterPiLow - sign * tail);
    const double excess = tangentExcess(rest, 0);
    const double tangent = rest + excess, side = isTurned ? -1 : 1;
    return sign * (side - 2 * (rest + (excess - tangent * tangent / (tangent + side))));
  }
  const double excess = tangentExcess(x, tail);
  const double tangent = x + excess;
  if (!isTurned) return tangent;
  // -1 / tangent alone has an error of up to two units in the last place
  const double high = upperHalf(tangent), low = excess - (high - x);
  const double inverse = -1 / tangent, roughly = upperHalf(inverse);
  return roughly + inverse * (1 + roughly * high + roughly * low);
}

/// @return The sine of an angle, with `quarters` added to its quarter turns.
double sineOf(const ReducedAngle& angle, unsigned quarters) {
  const double value = (quarters & 1U) == 0 ? sineNear0(angle.rest, angle.tail) : cosineNear0(angle.rest, angle.tail);
  return (quarters & 2U) == 0 ? value : -value;
}

}  // namespace

double sin(double angle) {
  if (std::abs(angle) < kTinyAngle) return angle;
  if (std::abs(angle) <= kQuarterPi) return sineNear0(angle, 0);
  if (!std::isfinite(angle)) return kNoAngle;
  const ReducedAngle reduced = reduceAngle(angle);
  return sineOf(reduced, reduced.quarters);
}

double cos(double angle) {
  if (std::abs(angle) <= kQuarterPi) return cosineNear0(angle, 0);
  if (!std::isfinite(angle)) return kNoAngle;
  const ReducedAngle reduced = reduceAngle(angle);
  return sineOf(reduced, reduced.quarters + 1);
}

SineAndCosine sinCos(double angle) {
  if (std::abs(angle) < kTinyAngle) return {angle, cosineNear0(angle, 0)};
  if (std::abs(angle) <= kQuarterPi) return {sineNear0(angle, 0), cosineNear0(angle, 0)};
  if (!std::isfinite(angle)) return {kNoAngle, kNoAngle};
  const ReducedAngle reduced = reduceAngle(angle);
  return {sineOf(reduced, reduced.quarters), sineOf(reduced, reduced.quarters + 1)};
}

double tan(double angle) {
  if (std::abs(angle) < kTinyAngle) return angle;
  if (std::abs(angle) <= kQuarterPi) return tangentNear0(angle, 0, false);
  if (!std::isfinite(angle)) return kNoAngle;
  const ReducedAngle reduced = reduceAngle(angle);
  return tangentNear0(reduced.rest, reduced.tail, (reduced.quarters & 1U) != 0);
}

}  // namespace pongsim::math
