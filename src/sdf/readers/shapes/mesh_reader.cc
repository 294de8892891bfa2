#include "sdf/readers/shapes/mesh_reader.hh"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>

#include "sdf/includes/asset_file.hh"
#include "sdf/includes/includes.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

void readSubmesh(const Element& element, description::Mesh& mesh, Context& context) {
  const Element* submesh = element.child("submesh");
  if (submesh == nullptr) return;
  mesh.submesh = childText(*submesh, "name");
  mesh.isCentered = readFlag(*submesh, "center", mesh.isCentered, context);
  if (mesh.submesh.empty()) {
    context.diagnostics.warning(submesh->position, "<submesh> has no <name>: the whole mesh is used");
  }
}

void readOptimization(const Element& element, description::Mesh& mesh, Context& context) {
  using description::MeshOptimization;
  constexpr std::array<std::string_view, 2> kWords{"convex_hull", "convex_decomposition"};
  constexpr std::array kMeanings{MeshOptimization::kConvexHull, MeshOptimization::kConvexDecomposition,
                                 MeshOptimization::kNone};
  mesh.optimization = kMeanings.at(readWordAttribute(element, "optimization", kWords.size(), kWords, context));
  const Element* settings = element.child("convex_decomposition");
  if (settings == nullptr) return;
  // maximum for a collision in pongsim
  constexpr long long kMostHulls = 1000;
  mesh.maxConvexHulls = static_cast<std::uint32_t>(
      readInteger(*settings, "max_convex_hulls", mesh.maxConvexHulls, 1, kMostHulls, context));
  mesh.voxelResolution = static_cast<std::uint32_t>(readInteger(*settings, "voxel_resolution", mesh.voxelResolution, 1,
                                                                std::numeric_limits<std::uint32_t>::max(), context));
}

}  // namespace

description::Mesh readMesh(const Element& element, const std::string& owner, bool isCollision, Context& context) {
  description::Mesh mesh;
  mesh.scale = readVector(element, "scale", mesh.scale, context);
  if (mesh.scale.cwiseAbs().minCoeff() == 0) {
    context.diagnostics.error(element.child("scale")->position, "the mesh of " + owner + " has a scale of zero");
  }
  readSubmesh(element, mesh, context);
  readOptimization(element, mesh, context);
  const AssetFile asset = findAsset(element, "mesh", owner, isCollision, context);
  mesh.uri = asset.uri;
  mesh.file = asset.path;
  if (asset.path.empty() || !isCollision) return mesh;

  const assets::MeshStore::Result found = context.includes.meshes().find(mesh.file, mesh.submesh, mesh.isCentered);
  if (const auto* problem = std::get_if<assets::Problem>(&found)) {
    asset.warn(*problem, context);
  } else {
    mesh.triangles = std::get<0>(found);
  }
  return mesh;
}

}  // namespace pongsim::sdf
