#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "assets/meshes/assimp.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

struct ReleaseImport {
  void operator()(const aiScene* scene) const { assimp().releaseImport(scene); }
};
using ImportedScene = std::unique_ptr<const aiScene, ReleaseImport>;

/// Nodes nested deeper than this are left out.
inline constexpr int kDeepestNode = 500;

/// A mesh and a node that places it; several nodes can place the same mesh.
struct PlacedMesh {
  const aiMesh* mesh;
  const aiNode* node;
  aiMatrix4x4 X_FileMesh;
};

/// @param submesh Name of a node or mesh; empty: all meshes.
/// @return The meshes with this name, in the order of the nodes; a problem if they have too many triangles.
std::variant<std::vector<PlacedMesh>, Problem> placedMeshes(const aiScene& scene, const std::string& submesh);

/// @return The problem that a vertex is not finite.
inline Problem notFinite() { return {"contains a coordinate that is not finite", {}}; }

/// Reads a mesh file of a kind and size that `readMeshFile` accepts.
/// @param dropped What to drop, as Assimp's `aiComponent`.
/// @param steps Assimp's processing steps, as `aiPostProcessSteps`.
std::variant<ImportedScene, Problem> importMesh(const std::filesystem::path& file, int dropped, unsigned steps);

}  // namespace pongsim::assets
