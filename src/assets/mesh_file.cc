#include "assets/mesh_file.hh"

#include <assimp/config.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>

#include "assets/assimp.hh"

namespace pongsim::assets {

namespace {

constexpr std::array<std::string_view, 5> kEndings{".dae", ".stl", ".obj", ".glb", ".gltf"};
constexpr int kDeepestNode = 500;

/// Triangles and nothing else: no normals, colours, materials, animations.
constexpr unsigned kSteps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                            aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure;
constexpr int kDropped = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                         aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                         aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

std::string lowerCaseEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return ending;
}

struct ReleaseProperties {
  void operator()(aiPropertyStore* store) const { assimp().releasePropertyStore(store); }
};
struct ReleaseImport {
  void operator()(const aiScene* scene) const { assimp().releaseImport(scene); }
};
using ScenePointer = std::unique_ptr<const aiScene, ReleaseImport>;

std::unique_ptr<aiPropertyStore, ReleaseProperties> importSettings() {
  std::unique_ptr<aiPropertyStore, ReleaseProperties> settings(assimp().createPropertyStore());
  const auto set = [&](const char* name, int value) { assimp().setImportPropertyInteger(settings.get(), name, value); };
  set(AI_CONFIG_PP_RVC_FLAGS, kDropped);
  set(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  set(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  set(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  return settings;
}

std::variant<ScenePointer, Problem> import(const std::filesystem::path& file) {
  // what went wrong Assimp keeps for the whole process
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto settings = importSettings();
  ScenePointer scene(assimp().importFileExWithProperties(file.c_str(), kSteps, nullptr, settings.get()));
  if (!scene) return Problem{"can't be read as a mesh", assimp().getErrorString()};
  return scene;
}

/// Copies the meshes of a scene, as its nodes place them.
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
    // a node may place the same mesh many times
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
    return Problem{"holds more than " + std::to_string(kMostTriangles) + " triangles, which is the limit", {}};
  }
  if (!copier.isFinite()) return Problem{"holds a coordinate that is not finite", {}};
  std::vector<MeshPart> parts = copier.take();
  if (parts.empty()) return Problem{"holds no triangles", {}};
  return parts;
}

}  // namespace

std::variant<std::vector<MeshPart>, Problem> readMeshFile(const std::filesystem::path& file) {
  const std::string ending = lowerCaseEnding(file);
  if (std::ranges::find(kEndings, ending) == kEndings.end()) {
    return Problem{"is of a kind that is not read", "meshes in .dae, .stl, .obj, .glb and .gltf are"};
  }
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return Problem{"can't be read: " + error.message(), {}};
  if (size > kLargestMeshFile) {
    return Problem{"is larger than " + std::to_string(kLargestMeshFile >> 20U) + " MiB, which is the limit", {}};
  }
  try {
    const auto imported = import(file);
    if (const auto* problem = std::get_if<Problem>(&imported)) return *problem;
    return partsOf(*std::get<ScenePointer>(imported));
  } catch (const std::exception& problem) {
    return Problem{"can't be read as a mesh", problem.what()};
  }
}

}  // namespace pongsim::assets
