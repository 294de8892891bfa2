#pragma once

#include <LinearMath/btVector3.h>

#include <cmath>

namespace pongsim::physics {

/// Velocities are rounded to multiples of this [m/s, rad/s]. That is far below their accuracy, but without it the
/// rounding errors of sums that cancel would change the bits of a resting body in each step.
inline constexpr double kRounded = 0x1p-50;

/// @return The nearest such multiple: adding and subtracting a large number drops the bits below the sum's last one.
inline double roundedVelocity(double value) {
  constexpr double kShift = 1.5 * 0x1p52 * kRounded;
  constexpr double kLargest = 0x1p50 * kRounded;
  return std::abs(value) < kLargest ? (value + kShift) - kShift : value;
}

inline btVector3 roundedVelocity(const btVector3& velocity) {
  return {roundedVelocity(velocity.x()), roundedVelocity(velocity.y()), roundedVelocity(velocity.z())};
}

}  // namespace pongsim::physics
