#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "assets/problem.hh"
#include "description/triangle_mesh.hh"

namespace pongsim::assets {

/// A part of a mesh file, placed as in the file [m].
struct MeshPart {
  /// Names of the node that places it and of the mesh itself: `<submesh>` can give either.
  std::string nodeName;
  std::string meshName;
  description::TriangleMesh mesh;
};

/// Larger files, and those with more triangles (Bullet counts them with 21 bits), are refused.
inline constexpr std::size_t kLargestMeshFile = std::size_t{256} << 20U;
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Reads a mesh in Collada (.dae), STL (.stl), Wavefront (.obj) or glTF (.glb, .gltf). As in Fortress, the unit of a
/// Collada file is applied and its up axis is not; nothing is rotated.
std::variant<std::vector<MeshPart>, Problem> readMeshFile(const std::filesystem::path& file);

}  // namespace pongsim::assets
