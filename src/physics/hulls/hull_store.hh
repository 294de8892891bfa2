#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "assets/file_cache.hh"
#include "description/geometry.hh"
#include "description/triangle_mesh.hh"
#include "physics/hulls/hull.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// A mesh and how to make its hulls.
struct HullRequest {
  std::shared_ptr<const description::TriangleMesh> mesh;
  Vector3 scale{1, 1, 1};
  /// 1: the convex hull of everything.
  std::size_t mostPieces = 1;
  /// See `DecompositionSettings`.
  double standOff = 0;
  /// Whether an open mesh is filled; if not, it is a sheet.
  bool fillsOpen = true;
  /// Its name in messages: "mesh '/a/b.obj'".
  std::string name = {};
};

/// @return The hulls that a moving shape needs; `mesh` is null if it needs none.
HullRequest requestFor(const description::Geometry& geometry);

/// The hulls of meshes, each computed once. Slow results are also cached in a folder for later runs.
class HullStore {
 public:
  /// @param cacheFolder Empty: nothing is kept beyond this store.
  explicit HullStore(std::filesystem::path cacheFolder = {});

  /// Computes those that are not known yet, in parallel.
  void prepare(std::span<const HullRequest> requests);

  /// @return The hulls of a mesh, at least one; empty if it has no vertices.
  const std::vector<Hull>& find(const HullRequest& request);

 private:
  using Key = std::tuple<const description::TriangleMesh*, double, double, double, std::size_t, double, bool>;
  struct Entry {
    std::shared_ptr<const description::TriangleMesh> mesh;
    std::vector<Hull> hulls;
  };
  static Key keyOf(const HullRequest& request);
  std::vector<Hull> fetch(const HullRequest& request) const;
  void keep(const std::string& name, const std::vector<Hull>& hulls) const;

  assets::FileCache cache_;
  std::map<Key, Entry> entries_;
};

}  // namespace pongsim::physics
