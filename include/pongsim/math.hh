#pragma once

#include "pongsim/export.hh"

/// Elementary functions with the same bits on every machine. Those of the C library depend on its version and on the
/// processor, for which it chooses variants at program start. These use only IEEE double arithmetic and square roots,
/// without fused operations. Everything that moves bodies, draws random numbers or computes sensor readings uses them.
/// Functions that are exact in every C library (`sqrt`, `fmod`, `remainder`, `floor`, ...) may be used as well.
///
/// Errors are below one unit in the last place, for `atan2` below one and a half. Outside of their domain the functions
/// return NaN.
namespace pongsim::math {

struct SineAndCosine {
  double sine;
  double cosine;
};

/// @param angle [rad], of any magnitude.
PONGSIM_API double sin(double angle);
PONGSIM_API double cos(double angle);
PONGSIM_API double tan(double angle);
/// @return The same bits as `sin` and `cos`, at little more than the cost of one.
PONGSIM_API SineAndCosine sinCos(double angle);

/// @return [rad], in [-pi/2, pi/2].
PONGSIM_API double asin(double sine);
/// @return [rad], in [0, pi].
PONGSIM_API double acos(double cosine);
/// @return [rad], in [-pi/2, pi/2].
PONGSIM_API double atan(double tangent);
/// @return Angle of the point (x, y) [rad], in [-pi, pi]; the special cases are those of IEEE 754.
PONGSIM_API double atan2(double y, double x);

PONGSIM_API double exp(double power);
/// @return exp(power) - 1, accurate for small arguments.
PONGSIM_API double expm1(double power);
/// @return The natural logarithm.
PONGSIM_API double log(double number);
/// @return log(1 + number), accurate for small arguments.
PONGSIM_API double log1p(double number);

/// @return The complementary error function, 2 / sqrt(pi) times the integral of exp(-t^2) from `number` on, with a
/// relative error of 1e-13.
PONGSIM_API double erfc(double number);

/// @return The length of (x, y), without intermediate overflow.
PONGSIM_API double hypot(double x, double y);

}  // namespace pongsim::math
