#include "assets/meshes/mesh_look.hh"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>

#include <cstddef>
#include <string_view>
#include <system_error>
#include <utility>

#include "assets/meshes/mesh_file.hh"
#include "assets/meshes/mesh_import.hh"

namespace pongsim::assets {

namespace {

using description::Material;

constexpr unsigned kLookSteps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                                aiProcess_GenNormals | aiProcess_FlipUVs | aiProcess_ValidateDataStructure;
constexpr int kNotDrawn = aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS | aiComponent_BONEWEIGHTS |
                          aiComponent_ANIMATIONS | aiComponent_LIGHTS | aiComponent_CAMERAS;

description::Color colorOf(const aiMaterial& material, const char* key, const description::Color& fallback) {
  aiColor4D color;
  if (assimp().getMaterialColor(&material, key, 0, 0, &color) != aiReturn_SUCCESS) return fallback;
  return {color.r, color.g, color.b, 1};
}

/// @return The texture file: next to the mesh, or in the folder where models have their textures, as in Fortress;
/// nothing if there is none. Textures embedded in the mesh file are not read.
std::filesystem::path textureOf(const aiMaterial& material, const std::filesystem::path& folder) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    aiString name;
    const aiReturn found =
        assimp().getMaterialTexture(&material, type, 0, &name, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
    if (found != aiReturn_SUCCESS) continue;
    for (const std::filesystem::path& place : {folder, folder / ".." / "materials" / "textures"}) {
      std::error_code error;
      const std::filesystem::path file = place / name.C_Str();
      if (std::filesystem::is_regular_file(file, error)) return file;
    }
  }
  return {};
}

std::optional<Material> materialOf(const aiMaterial& from, const std::filesystem::path& folder) {
  aiString name;
  assimp().getMaterialString(&from, "?mat.name", 0, 0, &name);
  // Assimp's placeholder for files without materials
  if (name.C_Str() == std::string_view(AI_DEFAULT_MATERIAL_NAME)) return std::nullopt;
  Material material;
  material.diffuse = colorOf(from, "$clr.diffuse", {0.7F, 0.7F, 0.7F, 1});
  material.ambient = material.diffuse;
  material.specular = colorOf(from, "$clr.specular", material.specular);
  material.emissive = colorOf(from, "$clr.emissive", material.emissive);
  const std::filesystem::path texture = textureOf(from, folder);
  if (!texture.empty()) {
    material.metal.emplace();
    material.metal->maps.albedo.file = texture;
    material.metal->metalness = 0;
  }
  return material;
}

/// @return A placed mesh; nothing if a vertex is not finite.
std::optional<MeshLook> lookOf(const PlacedMesh& placed) {
  const auto& [from, node, X_FileMesh] = placed;
  MeshLook look{node->mName.C_Str(), from->mName.C_Str(), {}, {}, {}};
  const aiMatrix3x3 normals = aiMatrix3x3(X_FileMesh).Inverse().Transpose();
  for (unsigned i = 0; i < from->mNumVertices; ++i) {
    const aiVector3D at = X_FileMesh * from->mVertices[i];
    MeshLook::Corner corner{{at.x, at.y, at.z}, Eigen::Vector3f::UnitZ()};
    if (!corner.position.allFinite()) return std::nullopt;
    if (from->HasNormals()) {
      const aiVector3D normal = normals * from->mNormals[i];
      corner.normal = Eigen::Vector3f(normal.x, normal.y, normal.z).stableNormalized();
    }
    if (from->HasTextureCoords(0)) corner.coordinates = {from->mTextureCoords[0][i].x, from->mTextureCoords[0][i].y};
    look.corners.push_back(corner);
  }
  for (unsigned i = 0; i < from->mNumFaces; ++i) {
    const aiFace& face = from->mFaces[i];
    if (face.mNumIndices == 3) look.triangles.insert(look.triangles.end(), face.mIndices, face.mIndices + 3);
  }
  return look;
}

/// Moves the centre of everything to the origin.
void center(std::vector<MeshLook>& looks) {
  Eigen::AlignedBox3f box;
  for (const MeshLook& look : looks) {
    for (const MeshLook::Corner& corner : look.corners) box.extend(corner.position);
  }
  for (MeshLook& look : looks) {
    for (MeshLook::Corner& corner : look.corners) corner.position -= box.center();
  }
}

}  // namespace

std::variant<std::vector<MeshLook>, Problem> readMeshLook(const std::filesystem::path& file, const std::string& submesh,
                                                          bool isCentered) {
  const auto imported = importMesh(file, kNotDrawn, kLookSteps);
  if (const auto* problem = std::get_if<Problem>(&imported)) return *problem;
  const aiScene& scene = *std::get<ImportedScene>(imported);
  const auto placed = placedMeshes(scene, submesh);
  if (const auto* problem = std::get_if<Problem>(&placed)) return *problem;
  std::vector<MeshLook> looks;
  for (const PlacedMesh& each : std::get<0>(placed)) {
    std::optional<MeshLook> look = lookOf(each);
    if (!look) return notFinite();
    if (look->triangles.empty()) continue;
    if (each.mesh->mMaterialIndex < scene.mNumMaterials) {
      look->material = materialOf(*scene.mMaterials[each.mesh->mMaterialIndex], file.parent_path());
    }
    looks.push_back(std::move(*look));
  }
  if (looks.empty()) return Problem{submesh.empty() ? "contains no triangles" : "has no submesh '" + submesh + "'", {}};
  if (isCentered && !submesh.empty()) center(looks);
  return looks;
}

}  // namespace pongsim::assets
