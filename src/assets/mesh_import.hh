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

/// Nodes nested deeper than this are left out.
inline constexpr int kDeepestNode = 500;

/// Reads a mesh file of a kind and size that `readMeshFile` accepts.
/// @param dropped What to drop, as Assimp's `aiComponent`.
/// @param steps Assimp's processing steps, as `aiPostProcessSteps`.
std::variant<ImportedScene, Problem> importMesh(const std::filesystem::path& file, int dropped, unsigned steps);

}  // namespace pongsim::assets
