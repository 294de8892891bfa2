#pragma once

#include <cstdint>
#include <vector>

#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// Oriented triangles that bound a body, or a sheet. They may overlap: a triangle and the same one turned round cancel
/// each other, so that a closed chain, in which at each edge as many triangles go one way as the other, has a volume
/// and can be cut by planes whatever it looks like (a cycle of simplicial homology).
struct TriangleChain {
  struct Triangle {
    std::uint32_t a, b, c;
    /// It closes a cut, and is no part of what the mesh shows.
    bool isCap = false;
  };
  std::vector<Vector3> points;
  std::vector<Triangle> triangles;
  bool isClosed = false;
};

/// @return The triangles of a mesh, points in the same place being one, mirrored where the scale does that. Triangles
/// without area are left out. Small holes are closed. What then does not bound a body is a sheet.
/// @param closesAll Whether large holes are closed, too: an open mesh then is filled.
TriangleChain makeChain(const description::TriangleMesh& mesh, const Vector3& scale, bool closesAll);

/// Makes it coarser, where it has more triangles than that, by putting points that are near each other into one.
void coarsen(TriangleChain& chain, std::size_t mostTriangles);

/// @return The parts that do not hang together, each of a positive volume: a closed part within another is a cavity of
/// that one, and one that is turned inside out is turned again. Of a sheet, all of it.
std::vector<TriangleChain> separateBodies(TriangleChain chain);

/// [m^3]; 0 of a sheet.
double volumeOf(const TriangleChain& chain);

/// Where normal · p = distance.
struct Plane {
  Vector3 normal;
  double distance;
};

/// What lies on the two sides of a plane, without what closes the cut.
struct Halves {
  TriangleChain front;
  TriangleChain back;
};

/// @param tolerance Points that are nearer to the plane lie in it [m].
/// @param closes Whether the halves of a closed chain are closed again.
Halves cut(const TriangleChain& chain, const Plane& plane, double tolerance, bool closes);

}  // namespace pongsim::physics
