#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::description {

/// A surface of triangles [m]. Every index is that of a vertex, and every vertex is finite.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace pongsim::description
