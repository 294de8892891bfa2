#include "assets/mesh_file.hh"

#include <assimp/mesh.h>
#include <assimp/postprocess.h>

#include <cmath>

#include "assets/mesh_import.hh"

namespace pongsim::assets {

namespace {

/// Keeps only triangles: no normals, colours, materials or animations.
constexpr unsigned kSteps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                            aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure;
constexpr int kDropped = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                         aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                         aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

/// Copies the meshes of a scene, placed by its nodes.
class SceneCopier {
 public:
  explicit SceneCopier(const aiScene& scene) : scene_(scene) {}

  void copy(const aiNode& node, const aiMatrix4x4& X_ParentNode, int depth) {
    if (depth > kDeepestNode) return;
    const aiMatrix4x4 X_FileNode = X_ParentNode * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes && !isTooLarge_; ++i) {
      copyMesh(*scene_.mMeshes[node.mMeshes[i]], node, X_FileNode);
    }
    for (unsigned i = 0; i < node.mNumChildren && !isTooLarge_; ++i) copy(*node.mChildren[i], X_FileNode, depth + 1);
  }

  bool isTooLarge() const { return isTooLarge_; }
  bool isFinite() const { return isFinite_; }
  std::vector<MeshPart> take() { return std::move(parts_); }

 private:
  void copyMesh(const aiMesh& from, const aiNode& node, const aiMatrix4x4& X_FileNode) {
    // counted for each use: nodes can place the same mesh many times
    triangleCount_ += from.mNumFaces;
    isTooLarge_ = triangleCount_ > kMostTriangles;
    if (isTooLarge_) return;
    MeshPart part{node.mName.C_Str(), from.mName.C_Str(), {}};
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D vertex = X_FileNode * from.mVertices[i];
      part.mesh.vertices.emplace_back(vertex.x, vertex.y, vertex.z);
      isFinite_ = isFinite_ && part.mesh.vertices.back().allFinite();
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices == 3) part.mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    if (!part.mesh.triangles.empty()) parts_.push_back(std::move(part));
  }

  const aiScene& scene_;
  std::vector<MeshPart> parts_;
  std::size_t triangleCount_ = 0;
  bool isTooLarge_ = false;
  bool isFinite_ = true;
};

std::variant<std::vector<MeshPart>, Problem> partsOf(const aiScene& scene) {
  SceneCopier copier(scene);
  if (scene.mRootNode != nullptr) copier.copy(*scene.mRootNode, aiMatrix4x4(), 0);
  if (copier.isTooLarge()) {
    return Problem{"contains more than " + std::to_string(kMostTriangles) + " triangles, which is the limit", {}};
  }
  if (!copier.isFinite()) return Problem{"contains a coordinate that is not finite", {}};
  std::vector<MeshPart> parts = copier.take();
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
