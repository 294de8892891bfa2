#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <variant>

#include "assets/meshes/mesh_file.hh"
#include "description/triangle_mesh.hh"

namespace pongsim::assets {

/// Meshes by file, each read once.
class MeshStore {
 public:
  using Result = std::variant<std::shared_ptr<const description::TriangleMesh>, Problem>;

  /// @param submesh Name of the part to use; empty: all parts as one.
  /// @param isCentered Whether to move the centre of the part's bounding box to the origin. Has no effect on the whole
  /// mesh.
  /// @return The same mesh for the same arguments.
  Result find(const std::filesystem::path& file, const std::string& submesh, bool isCentered);

 private:
  using Parts = std::variant<std::vector<MeshPart>, Problem>;

  std::map<std::filesystem::path, Parts> files_;
  std::map<std::tuple<std::filesystem::path, std::string, bool>, Result> meshes_;
};

}  // namespace pongsim::assets
