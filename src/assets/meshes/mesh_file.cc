#include "assets/meshes/mesh_file.hh"

#include <assimp/mesh.h>
#include <assimp/postprocess.h>

#include <cmath>

#include "assets/meshes/mesh_import.hh"

namespace pongsim::assets {

namespace {

/// Keeps only triangles: no normals, colours, materials or animations.
constexpr unsigned kSteps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                            aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure;
constexpr int kDropped = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                         aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                         aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

std::variant<std::vector<MeshPart>, Problem> partsOf(const aiScene& scene) {
  const auto placed = placedMeshes(scene, {});
  if (const auto* problem = std::get_if<Problem>(&placed)) return *problem;
  std::vector<MeshPart> parts;
  for (const auto& [from, node, X_FileMesh] : std::get<0>(placed)) {
    MeshPart part{node->mName.C_Str(), from->mName.C_Str(), {}};
    for (unsigned i = 0; i < from->mNumVertices; ++i) {
      const aiVector3D vertex = X_FileMesh * from->mVertices[i];
      part.mesh.vertices.emplace_back(vertex.x, vertex.y, vertex.z);
      if (!part.mesh.vertices.back().allFinite()) return notFinite();
    }
    for (unsigned i = 0; i < from->mNumFaces; ++i) {
      const aiFace& face = from->mFaces[i];
      if (face.mNumIndices == 3) part.mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    if (!part.mesh.triangles.empty()) parts.push_back(std::move(part));
  }
  if (parts.empty()) return Problem{"contains no triangles", {}};
  return parts;
}

}  // namespace

std::variant<std::vector<MeshPart>, Problem> readMeshFile(const std::filesystem::path& file) {
  const auto imported = importMesh(file, kDropped, kSteps);
  if (const auto* problem = std::get_if<Problem>(&imported)) return *problem;
  return partsOf(*std::get<ImportedScene>(imported));
}

}  // namespace pongsim::assets
