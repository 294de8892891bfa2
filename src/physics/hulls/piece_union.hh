#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "physics/hulls/hull.hh"

namespace pongsim::physics {

/// A part of a body, and the hull that stands for it.
struct Piece {
  ConvexHull hull;
  /// Of the part itself [m^3].
  double volume = 0;

  /// What the hull takes beside that [m^3].
  double excess() const { return std::max(0.0, hull.volume - volume); }
};

/// Joins pieces that touch and make one that is convex, and, while there are more than `most`, those that are nearest
/// to it, the best ones first.
std::vector<Piece> joinPieces(std::vector<Piece> pieces, std::size_t most,
                              const std::function<bool(const Piece&)>& isConvex);

}  // namespace pongsim::physics
