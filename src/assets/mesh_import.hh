#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "assets/assimp.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

struct ReleaseImport {
  void operator()(const aiScene* scene) const { assimp().releaseImport(scene); }
};
using ImportedScene = std::unique_ptr<const aiScene, ReleaseImport>;

/// Nodes that are deeper in a file are left out.
inline constexpr int kDeepestNode = 500;

/// Reads a mesh file of a kind that `readMeshFile` takes, and not larger than it allows.
/// @param dropped What is not wanted of it, as Assimp's `aiComponent`.
/// @param steps What Assimp is to do with it, as `aiPostProcessSteps`.
std::variant<ImportedScene, Problem> importMesh(const std::filesystem::path& file, int dropped, unsigned steps);

}  // namespace pongsim::assets
