#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "assets/problem.hh"
#include "description/material.hh"
#include "pongsim/types.hh"

namespace pongsim::assets {

/// A part of a mesh file as it is drawn, placed as in the file [m].
struct MeshLook {
  struct Corner {
    Eigen::Vector3f position;
    /// Unit vector.
    Eigen::Vector3f normal;
    /// Texture coordinates, from the left and from the top; 1 is the full size.
    Eigen::Vector2f coordinates{0, 0};
  };
  /// See `MeshPart`.
  std::string nodeName;
  std::string meshName;
  std::vector<Corner> corners;
  /// Vertex indices, three for each triangle.
  std::vector<std::uint32_t> triangles;
  /// Nothing if the file has none.
  std::optional<description::Material> material;
};

/// Reads a mesh like `readMeshFile`, with normals (computed if the file has none), texture coordinates, and its
/// materials: their colours and texture files.
/// @param submesh Name of the part to read; empty: all.
/// @param isCentered Whether to move the centre of the part's bounding box to the origin. Has no effect on the whole
/// mesh.
std::variant<std::vector<MeshLook>, Problem> readMeshLook(const std::filesystem::path& file, const std::string& submesh,
                                                          bool isCentered);

}  // namespace pongsim::assets
