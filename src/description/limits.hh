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

}  // namespace pongsim::description
