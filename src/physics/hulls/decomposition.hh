#pragma once

#include <cstddef>
#include <vector>

#include "physics/hulls/triangle_chain.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

struct DecompositionSettings {
  /// [1, 1000]
  std::size_t mostPieces = 64;
  /// Allowed mean distance of a piece from the surface, relative to the longest edge of the mesh's bounding box.
  double standOff = 0.005;
};

/// The corners of a convex piece.
using PieceCorners = std::vector<Vector3>;

struct Decomposition {
  std::vector<PieceCorners> pieces;
  /// Whether it ended as it should, and not because its cost is bounded.
  bool isComplete = true;
};

/// Convex decomposition: cuts a body or a sheet into nearly convex pieces and takes the convex hull of each. It tries
/// planes along re-entrant faces and edges and across the axes, and takes the one that leaves the least excess volume
/// in the hulls (greedily, as K. Mamou and F. Ghorbel do with voxels, A simple and efficient approach for 3D mesh
/// approximate convex decomposition, 2009). Then it joins pieces that are convex together. The same chain gives the
/// same bits.
/// @return One piece, the hull of everything, if the whole is convex within the tolerance; none if there are no
/// triangles.
Decomposition decompose(const TriangleChain& chain, const DecompositionSettings& settings);

}  // namespace pongsim::physics
