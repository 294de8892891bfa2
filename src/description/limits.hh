#pragma once

namespace pongsim::description {

/// Bounds of what a world may contain, in files and in whatever changes it while it runs: beyond them, the squares and
/// products of a step lose their meaning or overflow.
/// Of each coordinate of a position, in the world or in what holds it [m], and of a joint [m or rad].
inline constexpr double kLargestPosition = 1e9;
/// Of each component [m/s^2].
inline constexpr double kLargestGravity = 1e6;
/// Of a joint [m/s or rad/s].
inline constexpr double kLargestVelocity = 1e8;

/// Bounds of what a saved state may contain: whatever a step leaves is well within them.
/// Of each coordinate of a link, whose position is a sum of positions [m].
inline constexpr double kFarthestSaved = 10 * kLargestPosition;
/// Of each component of a link's velocity [m/s or rad/s].
inline constexpr double kFastestSaved = 1e10;
/// Of a step, as in files [s].
inline constexpr double kLongestSavedStep = 1e6;
/// Of each component of a force on a link or joint between two steps [N or N m].
inline constexpr double kStrongestSaved = 1e12;

/// Bounds of a mass [kg], of a factor of an inertia, and of damping and friction that are changed while a world runs.
inline constexpr double kLeastMass = 1e-12;
inline constexpr double kLargestMass = 1e12;
inline constexpr double kLargestCoefficient = 1e12;

}  // namespace pongsim::description
