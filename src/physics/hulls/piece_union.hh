#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "physics/hulls/hull.hh"

namespace pongsim::physics {

/// A part of a body, and the hull that represents it.
struct Piece {
  ConvexHull hull;
  /// Volume of the part itself [m^3].
  double volume = 0;

  /// Volume that the hull has beyond that [m^3].
  double excess() const { return std::max(0.0, hull.volume - volume); }
};

/// Joins touching pieces that together are convex. While there are more than `most`, it also joins those that are
/// nearest to convex. The best unions come first.
std::vector<Piece> joinPieces(std::vector<Piece> pieces, std::size_t most,
                              const std::function<bool(const Piece&)>& isConvex);

}  // namespace pongsim::physics
