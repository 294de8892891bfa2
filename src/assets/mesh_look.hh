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

/// A part of a mesh file as it is drawn, where the file places it [m].
struct MeshLook {
  struct Corner {
    Eigen::Vector3f position;
    /// Of length one.
    Eigen::Vector3f normal;
    /// In the texture: from the left and from the top, 1 being its size.
    Eigen::Vector2f coordinates{0, 0};
  };
  /// As `MeshPart`'s.
  std::string nodeName;
  std::string meshName;
  std::vector<Corner> corners;
  /// Indices of corners, three for each triangle.
  std::vector<std::uint32_t> triangles;
  /// Nothing where the file gives none.
  std::optional<description::Material> material;
};

/// Reads a mesh as `readMeshFile` does, with normals, which are made where it has none, with texture coordinates, and
/// with its materials: their colours and the files of their textures.
/// @param submesh Name of the one part that is wanted; empty: all.
/// @param isCentered The part's bounding box gets its centre in the origin. Of no effect on the whole.
std::variant<std::vector<MeshLook>, Problem> readMeshLook(const std::filesystem::path& file, const std::string& submesh,
                                                          bool isCentered);

}  // namespace pongsim::assets
