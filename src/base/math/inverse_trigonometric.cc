// Arcsine, arccosine and arctangent: the approximations of FreeBSD's msun (s_atan.c, e_atan2.c, e_asin.c, e_acos.c),
// which carry this notice: Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Permission to use, copy,
// modify, and distribute this software is freely granted, provided that this notice is preserved.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::math {

namespace {

constexpr double kPi = std::numbers::pi, kPiLow = 0x1.1a62633145c07p-53;
constexpr double kRightAngle = kPi / 2, kRightAngleLow = kPiLow / 2;
constexpr double kNoArc = std::numeric_limits<double>::quiet_NaN();

/// An angle in double-double precision.
struct Arc {
  double high;
  double low;
};
// arctangents of 1/2, 1, 3/2 and infinity
constexpr Arc kArcOfHalf{4.63647609000806093515e-01, 2.26987774529616870924e-17};
constexpr Arc kArcOf1{7.85398163397448278999e-01, 3.06161699786838301793e-17};
constexpr Arc kArcOf3Halves{9.82793723247329054082e-01, 1.39033110312309984516e-17};
constexpr Arc kArcOfInfinity{kRightAngle, kRightAngleLow};

/// @return The factor in atan(x) = x - x * factor, |x| below 7/16.
double arcTangentShort(double x) {
  const double z = x * x, w = z * z;
  const double even = z * (3.33333333333329318027e-01 +
                           w * (1.42857142725034663711e-01 +
                                w * (9.09088713343650656196e-02 +
                                     w * (6.66107313738753120669e-02 +
                                          w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const double odd =
      w *
      (-1.99999999998764832476e-01 +
       w * (-1.11111104054623557880e-01 +
            w * (-7.69187620504482999495e-02 + w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
  return even + odd;
}

/// @return a + b, given a and tan(b).
double arcPlus(const Arc& arc, double rest) { return arc.high - (rest * arcTangentShort(rest) - arc.low - rest); }

double atanOfPositive(double x) {
  if (x < 0.4375) return x < 0x1p-27 ? x : x - x * arcTangentShort(x);
  if (x < 0.6875) return arcPlus(kArcOfHalf, (2 * x - 1) / (2 + x));
  if (x < 1.1875) return arcPlus(kArcOf1, (x - 1) / (x + 1));
  if (x < 2.4375) return arcPlus(kArcOf3Halves, (x - 1.5) / (1 + 1.5 * x));
  return arcPlus(kArcOfInfinity, -1 / x);
}

/// @return (asin(x) - x) / x as a function of x squared, up to 1/4.
double arcSineExcess(double z) {
  const double above = z * (1.66666666666666657415e-01 +
                            z * (-3.25565818622400915405e-01 +
                                 z * (2.01212532134862925881e-01 +
                                      z * (-4.00555345006794114027e-02 +
                                           z * (7.91534994289814532176e-04 + z * 3.47933107596021167570e-05)))));
  const double below =
      1 + z * (-2.40339491173441421878e+00 +
               z * (2.02094576023350569471e+00 + z * (-6.88283971605453293030e-01 + z * 7.70381505559019352791e-02)));
  return above / below;
}

/// A square root in two parts; the first has half of the digits.
struct Root {
  explicit Root(double square)
      : whole(std::sqrt(square)),
        high(std::bit_cast<double>(std::bit_cast<std::uint64_t>(whole) & 0xffffffff00000000U)),
        low((square - high * high) / (whole + high)) {}
  double whole;
  double high;
  double low;
};

/// @return asin(x), x in [1/2, 1): pi/2 - 2 asin(sqrt((1 - x) / 2)).
double asinOfLarge(double x) {
  const double square = (1 - x) * 0.5;
  const double excess = arcSineExcess(square);
  if (x > 0.975) {
    const double root = std::sqrt(square);
    return kRightAngle - (2 * (root + root * excess) - kRightAngleLow);
  }
  const Root root(square);
  constexpr double kHalf = kRightAngle / 2;
  return kHalf - (2 * root.whole * excess - (kRightAngleLow - 2 * root.low) - (kHalf - 2 * root.high));
}

}  // namespace

double atan(double tangent) {
  if (std::isnan(tangent)) return kNoArc;
  return std::copysign(atanOfPositive(std::abs(tangent)), tangent);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNoArc;
  const double high = std::abs(y), wide = std::abs(x);
  double arc = 0;
  if (high == 0) {
    arc = 0;
  } else if (wide == 0 || (std::isinf(high) && !std::isinf(wide))) {
    return std::copysign(kRightAngle, y);
  } else if (std::isinf(high)) {
    arc = kRightAngle / 2;
  } else if (!std::isinf(wide)) {
    const double steepness = high / wide;
    if (steepness >= 0x1p66) return std::copysign(kRightAngle, y);
    arc = atanOfPositive(steepness);
  }
  // by the sign bit, because x can be -0: atan2(0, -0) is pi
  if (!std::signbit(x)) return std::copysign(arc, y);
  return std::copysign(kPi - (arc - kPiLow), y);
}

double asin(double sine) {
  const double size = std::abs(sine);
  if (size < 0.5) return size < 0x1p-26 ? sine : sine + sine * arcSineExcess(sine * sine);
  if (size < 1) return std::copysign(asinOfLarge(size), sine);
  return size == 1 ? std::copysign(kRightAngle, sine) : kNoArc;
}

double acos(double cosine) {
  const double size = std::abs(cosine);
  if (size < 0.5) return kRightAngle - (cosine - (kRightAngleLow - cosine * arcSineExcess(cosine * cosine)));
  if (size == 1) return cosine < 0 ? kPi : 0;
  if (!(size < 1)) return kNoArc;
  if (cosine < 0) {
    const double square = (1 + cosine) * 0.5, root = std::sqrt(square);
    return 2 * (kRightAngle - (root + (arcSineExcess(square) * root - kRightAngleLow)));
  }
  const double square = (1 - cosine) * 0.5;
  const Root root(square);
  return 2 * (root.high + (arcSineExcess(square) * root.whole + root.low));
}

}  // namespace pongsim::math
