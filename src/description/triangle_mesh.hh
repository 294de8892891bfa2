#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::description {

/// A triangle mesh [m]. All indices are valid, and all vertices are finite.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace pongsim::description
