#pragma once

#include <algorithm>

namespace pongsim::physics {

/// Bullet rounds edges by the margin. It stays far below the size of the part, and below a millimetre, so that a wheel
/// stands on its whole width.
/// @param smallestHalfLength Of the part [m].
inline double marginFor(double smallestHalfLength) { return std::min(0.001, 0.01 * smallestHalfLength); }

}  // namespace pongsim::physics
