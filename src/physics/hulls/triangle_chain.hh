#pragma once

#include <cstdint>
#include <vector>

#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// Oriented triangles that bound a body, or form a sheet. They may overlap: a triangle and its flipped copy cancel out.
/// In a closed chain each edge is passed equally often both ways (a cycle of simplicial homology), so that it has a
/// volume and can be cut by planes, whatever it looks like.
struct TriangleChain {
  struct Triangle {
    std::uint32_t a, b, c;
    /// Closes a cut; not part of the mesh's visible surface.
    bool isCap = false;
  };
  std::vector<Vector3> points;
  std::vector<Triangle> triangles;
  bool isClosed = false;
};

/// @return The triangles of a mesh, with points in the same place merged, mirrored if the scale is. Triangles without
/// area are left out. Small holes are closed. If the result does not bound a body, it is a sheet.
/// @param closesAll Whether large holes are closed too, so that an open mesh is filled.
TriangleChain makeChain(const description::TriangleMesh& mesh, const Vector3& scale, bool closesAll);

/// Coarsens a chain with more triangles than this, by merging points that are near each other.
void coarsen(TriangleChain& chain, std::size_t mostTriangles);

/// @return The disconnected parts, each with a positive volume: a closed part inside another is a cavity of it, and a
/// part that is inside out is flipped. A sheet is returned as a whole.
std::vector<TriangleChain> separateBodies(TriangleChain chain);

/// [m^3]; 0 for a sheet.
double volumeOf(const TriangleChain& chain);

/// The points p with normal · p = distance.
struct Plane {
  Vector3 normal;
  double distance;
};

/// The two sides of a plane, without the caps of the cut.
struct Halves {
  TriangleChain front;
  TriangleChain back;
};

/// @param tolerance Points closer to the plane than this lie in it [m].
/// @param closes Whether the halves of a closed chain are closed again.
Halves cut(const TriangleChain& chain, const Plane& plane, double tolerance, bool closes);

}  // namespace pongsim::physics
