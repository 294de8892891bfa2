#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "assets/mesh_store.hh"
#include "assets/problem.hh"
#include "description/geometry.hh"
#include "description/triangle_mesh.hh"
#include "pongsim/types.hh"
#include "sensing/shape.hh"

namespace pongsim::sensing {

/// Appearance of a geometry.
struct Look {
  /// Nothing: invisible.
  std::variant<std::monostate, Shape, std::shared_ptr<const description::TriangleMesh>> body = std::monostate();
  Pose X_GeometryBody = {};
  Vector3 scale = {1, 1, 1};
};

/// Reads files referred to by descriptions; the loader does not read those of visuals.
class LookReader {
 public:
  /// Called with a file that can't be used: "mesh", the file, the problem.
  using Warn = std::function<void(const std::string&, const std::filesystem::path&, const assets::Problem&)>;

  /// @return The same triangles for the same mesh.
  Look look(const description::Geometry& geometry, const Warn& warn);

 private:
  assets::MeshStore meshes_;
};

}  // namespace pongsim::sensing
