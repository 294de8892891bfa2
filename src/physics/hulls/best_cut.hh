#pragma once

#include <optional>

#include "physics/hulls/hull.hh"
#include "physics/hulls/triangle_chain.hh"

namespace pongsim::physics {

/// @return Points closer to a plane than this lie in it [m]; allows for rounding in mesh files.
double cutTolerance(const TriangleChain& chain);

/// @return The plane that leaves the least excess volume in the hulls of the two sides; nothing if no plane cuts it.
std::optional<Plane> bestCut(const TriangleChain& chain, const ConvexHull& hull);

}  // namespace pongsim::physics
