#pragma once

#include <vector>

#include "physics/hulls/chain_edges.hh"

namespace pongsim::physics {

/// Closes the areas bounded by edges in a plane with caps that face outward. Caps lie within the cut and do not
/// overlap, unless rounding makes that impossible: then they are fans, which do.
/// @param boundary In the direction in which the existing triangles run through the edges.
void addCap(const std::vector<Vector3>& points, const std::vector<DirectedEdge>& boundary, const Vector3& outwards,
            std::vector<TriangleChain::Triangle>& triangles);

}  // namespace pongsim::physics
