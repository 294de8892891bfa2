#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "assets/meshes/mesh_store.hh"
#include "assets/problem.hh"
#include "description/geometry.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"
#include "sensing/shape.hh"

namespace pongsim::sensing {

/// The shape or mesh that rays are intersected with, for a geometry of a description.
struct RayGeometry {
  /// std::monostate: nothing is hit.
  std::variant<std::monostate, Shape, std::shared_ptr<const description::TriangleMesh>> body = std::monostate();
  Pose X_GeometryBody = {};
  Vector3 scale = {1, 1, 1};
};

/// Makes ray geometries. It reads meshes and heightmaps of visuals, which the loader does not read.
class RayGeometryReader {
 public:
  /// Called with a file that can't be used: "mesh", the file, the problem.
  using Warn = std::function<void(const std::string&, const std::filesystem::path&, const assets::Problem&)>;

  /// @return The geometry. Equal meshes share their triangles.
  RayGeometry read(const description::Geometry& geometry, const Warn& warn);

 private:
  assets::MeshStore meshes_;
};

}  // namespace pongsim::sensing
