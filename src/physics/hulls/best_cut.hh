#pragma once

#include <optional>

#include "physics/hulls/hull.hh"
#include "physics/hulls/triangle_chain.hh"

namespace pongsim::physics {

/// @return Points that are nearer to a plane than that lie in it [m]: files round.
double cutTolerance(const TriangleChain& chain);

/// @return The plane after which the hulls of both sides stand out least; nothing where none cuts it.
std::optional<Plane> bestCut(const TriangleChain& chain, const ConvexHull& hull);

}  // namespace pongsim::physics
