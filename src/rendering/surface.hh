#pragma once

#include <cstdint>
#include <vector>

#include "description/geometry.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"

namespace pongsim::rendering {

/// A corner of a surface.
struct Vertex {
  Eigen::Vector3f position;
  /// Of length one, outwards.
  Eigen::Vector3f normal;
  /// In its texture: from the left and from the top, 1 being its size.
  Eigen::Vector2f coordinates{0, 0};
};

/// Triangles as they are drawn, seen from where their corners go round counter-clockwise.
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
Surface capsuleSurface(const description::Capsule& capsule);
/// From -0.5 to 0.5 along x and y, seen from above.
Surface planeSurface();
/// @param isSmooth Normals are those of all triangles at a corner, in place of each triangle's own.
Surface meshSurface(const description::TriangleMesh& mesh, bool isSmooth);

}  // namespace pongsim::rendering
