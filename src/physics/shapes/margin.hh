#pragma once

#include <algorithm>

namespace pongsim::physics {

/// The margin by which Bullet rounds edges. It is far smaller than the part and at most a millimetre, so that a wheel
/// stands on its full width.
/// @param smallestHalfLength Of the part [m].
inline double marginFor(double smallestHalfLength) { return std::min(0.001, 0.01 * smallestHalfLength); }

}  // namespace pongsim::physics
