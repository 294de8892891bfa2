#pragma once

#include "pongsim/export.hh"

/// Elementary functions whose bits are the same on every machine. Those of the C library differ by its version and by
/// the processor, for which it chooses variants when a program starts. These are made of IEEE arithmetic in double
/// precision and of square roots alone, nothing of it fused. Whatever moves bodies, draws numbers or reckons what a
/// sensor measures uses them; what is exact in every C library (`sqrt`, `fmod`, `remainder`, `floor`, ...) may stay.
///
/// Errors are below one unit in the last place, of `atan2` below one and a half. Where a function has no value the
/// result is NaN.
namespace pongsim::math {

struct SineAndCosine {
  double sine;
  double cosine;
};

/// @param angle [rad], of any size.
PONGSIM_API double sin(double angle);
PONGSIM_API double cos(double angle);
PONGSIM_API double tan(double angle);
/// @return The bits of `sin` and `cos`, for little more than the cost of one.
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
/// @return exp(power) - 1, without loss where that is small.
PONGSIM_API double expm1(double power);
/// @return The natural logarithm.
PONGSIM_API double log(double number);
/// @return log(1 + number), without loss where that is small.
PONGSIM_API double log1p(double number);

/// @return 2 / sqrt(pi) times the integral of exp(-t^2) from `number` on, to 1e-13 of it.
PONGSIM_API double erfc(double number);

/// @return The length of (x, y), without overflow on the way.
PONGSIM_API double hypot(double x, double y);

}  // namespace pongsim::math
