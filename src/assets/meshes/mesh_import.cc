#include "assets/meshes/mesh_import.hh"

#include <assimp/config.h>
#include <assimp/mesh.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "assets/meshes/collada_file.hh"
#include "assets/meshes/gltf_check.hh"
#include "assets/meshes/mesh_file.hh"
#include "assets/meshes/mesh_files.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace {

constexpr std::array<std::string_view, 5> kEndings{".dae", ".stl", ".obj", ".glb", ".gltf"};

std::string lowerCaseEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return ending;
}

struct ReleaseProperties {
  void operator()(aiPropertyStore* store) const { assimp().releasePropertyStore(store); }
};

std::unique_ptr<aiPropertyStore, ReleaseProperties> importSettings(int dropped) {
  std::unique_ptr<aiPropertyStore, ReleaseProperties> settings(assimp().createPropertyStore());
  const auto set = [&](const char* name, int value) { assimp().setImportPropertyInteger(settings.get(), name, value); };
  set(AI_CONFIG_PP_RVC_FLAGS, dropped);
  set(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  set(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  set(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  set(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
  return settings;
}

ImportedScene import(const std::filesystem::path& file, std::string content, std::string_view ending, unsigned steps,
                     const aiPropertyStore& settings) {
  if (ending == ".dae") {
    const std::string text = readCollada(content);
    const auto size = static_cast<unsigned>(text.size());
    return ImportedScene(assimp().importFileFromMemoryWithProperties(text.data(), size, steps, "dae", &settings));
  }
  if (ending == ".glb" || ending == ".gltf") checkGltf(content);
  MeshFiles files(file, std::move(content));
  return ImportedScene(assimp().importFileExWithProperties(file.c_str(), steps, files.io(), &settings));
}

/// Adds the meshes of a node and of those below it.
/// @param triangleCount Counts each use of a mesh.
/// @return False, with some meshes left out, if there are too many triangles.
bool addPlaced(const aiScene& scene, const std::string& submesh, const aiNode& node, const aiMatrix4x4& X_ParentNode,
               int depth, std::size_t& triangleCount, std::vector<PlacedMesh>& placed) {
  if (depth > kDeepestNode) return true;
  const aiMatrix4x4 X_FileNode = X_ParentNode * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    if (!submesh.empty() && node.mName.C_Str() != submesh && mesh.mName.C_Str() != submesh) continue;
    triangleCount += mesh.mNumFaces;
    if (triangleCount > kMostTriangles) return false;
    placed.push_back({&mesh, &node, X_FileNode});
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    if (!addPlaced(scene, submesh, *node.mChildren[i], X_FileNode, depth + 1, triangleCount, placed)) return false;
  }
  return true;
}

}  // namespace

std::variant<std::vector<PlacedMesh>, Problem> placedMeshes(const aiScene& scene, const std::string& submesh) {
  std::vector<PlacedMesh> placed;
  std::size_t triangleCount = 0;
  if (scene.mRootNode == nullptr || addPlaced(scene, submesh, *scene.mRootNode, {}, 0, triangleCount, placed))
    return placed;
  return Problem{"contains more than " + std::to_string(kMostTriangles) + " triangles, which is the limit", {}};
}

std::variant<ImportedScene, Problem> importMesh(const std::filesystem::path& file, int dropped, unsigned steps) {
  const std::string ending = lowerCaseEnding(file);
  if (std::ranges::find(kEndings, ending) == kEndings.end()) {
    return Problem{"is not in a supported format", "supported formats are .dae, .stl, .obj, .glb and .gltf"};
  }
  auto read = base::readRegularFile(file, kLargestMeshFile);
  if (auto* unreadable = std::get_if<base::Unreadable>(&read)) return Problem{std::move(unreadable->reason), {}};
  try {
    // Assimp keeps error messages for the whole process
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const auto settings = importSettings(dropped);
    ImportedScene scene = import(file, std::move(std::get<std::string>(read)), ending, steps, *settings);
    if (!scene) return Problem{"can't be read as a mesh", assimp().getErrorString()};
    return scene;
  } catch (const std::exception& problem) {
    return Problem{"can't be read as a mesh", problem.what()};
  }
}

}  // namespace pongsim::assets
