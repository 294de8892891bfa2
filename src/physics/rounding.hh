#pragma once

#include <LinearMath/btVector3.h>

#include <cmath>

namespace pongsim::physics {

/// Velocities are multiples of that [m/s, rad/s]: far less than what is known of them, but what rests so has the same
/// ones after each step, where the rounding of sums that cancel would make it tremble.
inline constexpr double kRounded = 0x1p-50;

/// @return The nearest such multiple. What is added to and taken from a number, rounds it to the last bit of their sum.
inline double roundedVelocity(double value) {
  constexpr double kShift = 1.5 * 0x1p52 * kRounded;
  constexpr double kLargest = 0x1p50 * kRounded;
  return std::abs(value) < kLargest ? (value + kShift) - kShift : value;
}

inline btVector3 roundedVelocity(const btVector3& velocity) {
  return {roundedVelocity(velocity.x()), roundedVelocity(velocity.y()), roundedVelocity(velocity.z())};
}

}  // namespace pongsim::physics
