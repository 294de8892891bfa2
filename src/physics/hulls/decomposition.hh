#pragma once

#include <cstddef>
#include <vector>

#include "physics/hulls/triangle_chain.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

struct DecompositionSettings {
  /// [1, 1000]
  std::size_t mostPieces = 64;
  /// How far a piece may stand off the surface on average, in parts of the longest edge of the mesh's box.
  double standOff = 0.005;
};

/// The corners of a convex piece.
using PieceCorners = std::vector<Vector3>;

/// Cuts a body or a sheet into pieces that are nearly convex, and takes the convex hull of each. Planes along faces and
/// edges that are re-entrant, and such across the axes, are tried; the one after which hulls stand out least is taken
/// (greedily, as K. Mamou and F. Ghorbel do with voxels, A simple and efficient approach for 3D mesh approximate convex
/// decomposition, 2009). Then pieces that are convex together are joined again. The same bits for the same chain.
/// @return One piece, the hull of all, where the whole is convex within the tolerance; nothing where there are no
/// triangles.
std::vector<PieceCorners> decompose(const TriangleChain& chain, const DecompositionSettings& settings);

}  // namespace pongsim::physics
