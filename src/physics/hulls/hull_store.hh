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

/// A mesh and how its hulls are to be made.
struct HullRequest {
  std::shared_ptr<const description::TriangleMesh> mesh;
  Vector3 scale{1, 1, 1};
  /// One: the convex hull of all.
  std::size_t mostPieces = 1;
  /// As `DecompositionSettings` has it.
  double standOff = 0;
  /// Whether an open mesh is filled; else it is a sheet.
  bool fillsOpen = true;
  /// What it is, for messages: "mesh '/a/b.obj'".
  std::string name = {};
};

/// @return How a shape moves, where that is as hulls; `mesh` is null where it is not.
HullRequest requestFor(const description::Geometry& geometry);

/// The hulls of meshes, each worked out once: what takes long is kept for later runs in a folder.
class HullStore {
 public:
  /// @param cacheFolder Empty: nothing is kept beyond this store.
  explicit HullStore(std::filesystem::path cacheFolder = {});

  /// Works out those that are not known yet, side by side.
  void prepare(std::span<const HullRequest> requests);

  /// @return The hulls of a mesh, one at least; empty where it has no vertex.
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
