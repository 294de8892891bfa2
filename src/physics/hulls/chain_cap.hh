#pragma once

#include <vector>

#include "physics/hulls/chain_edges.hh"

namespace pongsim::physics {

/// Closes what edges in a plane bound, by caps that show outwards. They lie within the cut and do not overlap; where
/// rounding has made that impossible, they are fans, which do.
/// @param boundary As the triangles that are there pass it.
void addCap(const std::vector<Vector3>& points, const std::vector<DirectedEdge>& boundary, const Vector3& outwards,
            std::vector<TriangleChain::Triangle>& triangles);

}  // namespace pongsim::physics
