#pragma once

#include "description/geometry.hh"
#include "description/triangle_mesh.hh"

namespace pongsim::description {

/// @return A pyramid in place of a cone, of the same height, volume and centroid: its corners lie 0.14 % of the radius
/// outside.
TriangleMesh coneTriangles(const Cone& cone);

}  // namespace pongsim::description
