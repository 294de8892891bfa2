#pragma once

#include <cstdint>
#include <vector>

#include "assets/meshes/mesh_look.hh"
#include "description/geometry.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// A vertex: position, normal (outward), texture coordinates.
using Vertex = assets::MeshLook::Corner;

/// Triangles to be drawn, visible from the side where their corners are counter-clockwise.
struct Surface {
  std::vector<Vertex> vertices;
  /// Three for each triangle.
  std::vector<std::uint32_t> corners;

  Eigen::AlignedBox3d bounds() const;
};

/// From -0.5 to 0.5 along each axis.
Surface boxSurface();
/// Of radius 1.
Surface sphereSurface();
/// Of radius 1, from -0.5 to 0.5 along z.
Surface cylinderSurface();
/// Of radius 1, its tip at 0.5 and its base at -0.5 along z.
Surface coneSurface();
Surface capsuleSurface(const description::Capsule& capsule);
/// From -0.5 to 0.5 along x and y, visible from above.
Surface planeSurface();
/// @param isSmooth Normals are averaged over all triangles at a corner, instead of each triangle's own.
Surface meshSurface(const description::TriangleMesh& mesh, bool isSmooth);

}  // namespace pongsim::rendering
