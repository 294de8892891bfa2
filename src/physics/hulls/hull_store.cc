#include "physics/hulls/hull_store.hh"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "base/hash.hh"
#include "physics/hulls/decomposition.hh"
#include "physics/hulls/hull_code.hh"
#include "physics/hulls/triangle_chain.hh"
#include "physics/shapes/margin.hh"
#include "pongsim/log.hh"
#include "pongsim/math.hh"
#include "shared/threads/workers.hh"

namespace pongsim::physics {

namespace {

/// Increase this whenever the same mesh gives other hulls than before.
constexpr std::uint64_t kMethod = 1;
/// With fewer triangles, computing the hulls is faster than reading a file.
constexpr std::size_t kFewTriangles = 256;
/// Meshes with more triangles are coarsened before cutting.
constexpr std::size_t kMostTriangles = 6000;

const Logger& logger() {
  static const Logger logger("physics");
  return logger;
}

/// @return The file's name: 128 bits of a hash of everything the hulls depend on.
std::string fileNameOf(const HullRequest& request) {
  base::Hash hashes[2];
  hashes[1].add(std::string_view("second"));
  const auto add = [&](auto value) {
    for (base::Hash& hash : hashes) hash.add(value);
  };
  add(kMethod);
  add(std::uint64_t{request.mostPieces});
  add(request.standOff);
  add(std::uint64_t{request.fillsOpen});
  for (const double value : {request.scale.x(), request.scale.y(), request.scale.z()}) add(value);
  add(std::uint64_t{request.mesh->vertices.size()});
  for (const Vector3& vertex : request.mesh->vertices) {
    for (const double value : {vertex.x(), vertex.y(), vertex.z()}) add(value);
  }
  for (const auto& [a, b, c] : request.mesh->triangles) {
    add(std::uint64_t{a} << 32U | b);
    add(std::uint64_t{c});
  }
  char name[40];
  std::snprintf(name, sizeof name, "%016llx%016llx", static_cast<unsigned long long>(hashes[0].value()),
                static_cast<unsigned long long>(hashes[1].value()));
  return name;
}

std::vector<Vector3> scaledVertices(const HullRequest& request) {
  std::vector<Vector3> points;
  points.reserve(request.mesh->vertices.size());
  for (const Vector3& vertex : request.mesh->vertices) points.push_back(vertex.cwiseProduct(request.scale));
  return points;
}

Eigen::AlignedBox3d boxOf(const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) box.extend(point);
  return box;
}

/// @return Whether the hulls can be the mesh's: all lie within its bounding box.
bool fits(const std::vector<Hull>& hulls, const Eigen::AlignedBox3d& box) {
  const double slack = 1e-3 * box.sizes().maxCoeff();
  const Eigen::AlignedBox3d wide(box.min() - Vector3::Constant(slack), box.max() + Vector3::Constant(slack));
  for (const Hull& hull : hulls) {
    if (hull.margin > box.sizes().maxCoeff()) return false;
    if (!std::ranges::all_of(hull.corners, [&](const Vector3& corner) { return wide.contains(corner); })) return false;
  }
  return true;
}

struct Hulls {
  std::vector<Hull> all;
  /// Whether the mesh has as many pieces as it needs.
  bool areComplete = true;
};

Hulls makeHulls(const HullRequest& request, const std::vector<Vector3>& points) {
  const Eigen::AlignedBox3d box = boxOf(points);
  // larger values make no sense for a shape
  constexpr double kLargest = 1e9;
  if (request.mostPieces == 1 || !(box.min().cwiseAbs().maxCoeff() + box.max().cwiseAbs().maxCoeff() < kLargest)) {
    return {{makeHull(points)}};
  }
  TriangleChain chain = makeChain(*request.mesh, request.scale, request.fillsOpen);
  coarsen(chain, kMostTriangles);
  // large triangles in disorder do not become fewer
  if (chain.triangles.size() > kMostTriangles) return {{makeHull(points)}, false};
  const Decomposition made = decompose(chain, {request.mostPieces, request.standOff});
  if (made.pieces.size() < 2) return {{makeHull(points)}, made.isComplete};
  Hulls hulls{{}, made.isComplete};
  for (const PieceCorners& piece : made.pieces) {
    const double thickness = marginFor(box.sizes().maxCoeff() / 2);
    hulls.all.push_back(chain.isClosed ? makeHull(piece) : makeSheet(piece, thickness));
  }
  return hulls;
}

std::string sentenceOf(const HullRequest& request, std::size_t hulls) {
  const std::string text =
      request.name + " of " + std::to_string(request.mesh->triangles.size()) + " triangles moves as ";
  return text + (hulls == 1 ? "its convex hull" : std::to_string(hulls) + " convex pieces");
}

}  // namespace

HullRequest requestFor(const description::Geometry& geometry) {
  HullRequest request;
  const DecompositionSettings usual;
  if (const auto* mesh = std::get_if<description::Mesh>(&geometry)) {
    request = {mesh->triangles, mesh->scale, usual.mostPieces, usual.standOff, true, {}};
    request.name = "mesh '" + mesh->file.string() + "'";
    if (mesh->optimization == description::MeshOptimization::kConvexHull) {
      request.mostPieces = 1;
    } else if (mesh->optimization == description::MeshOptimization::kConvexDecomposition) {
      request.mostPieces = mesh->maxConvexHulls;
      request.fillsOpen = false;
      // half a voxel or less, like the usual decomposition with 200,000 voxels
      request.standOff = 0.3 / math::exp(math::log(static_cast<double>(mesh->voxelResolution)) / 3);
    }
  } else if (const auto* line = std::get_if<description::Polyline>(&geometry)) {
    request = {line->triangles, {1, 1, 1}, usual.mostPieces, usual.standOff, true, "polyline"};
  } else if (const auto* map = std::get_if<description::Heightmap>(&geometry)) {
    request = {map->triangles, {1, 1, 1}, 1, 0, true, "heightmap"};
  }
  return request;
}

HullStore::HullStore(std::filesystem::path cacheFolder) : cache_(std::move(cacheFolder)) {}

HullStore::Key HullStore::keyOf(const HullRequest& request) {
  return {request.mesh.get(), request.scale.x(), request.scale.y(), request.scale.z(),
          request.mostPieces, request.standOff,  request.fillsOpen};
}

void HullStore::prepare(std::span<const HullRequest> requests) {
  std::vector<std::pair<const HullRequest*, Entry*>> missing;
  for (const HullRequest& request : requests) {
    if (request.mesh == nullptr) continue;
    const auto [place, isNew] = entries_.try_emplace(keyOf(request), Entry{request.mesh, {}});
    if (isNew) missing.emplace_back(&request, &place->second);
  }
  constexpr unsigned kMostThreads = 8;
  const auto most =
      std::min<std::size_t>(std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads), missing.size());
  shared::Workers workers(static_cast<int>(std::max<std::size_t>(most, 1)), 1);
  workers.forEach(missing.size(), [&](std::size_t i, int) { missing[i].second->hulls = fetch(*missing[i].first); });
}

const std::vector<Hull>& HullStore::find(const HullRequest& request) {
  const auto known = entries_.find(keyOf(request));
  if (known != entries_.end()) return known->second.hulls;
  prepare({&request, 1});
  return entries_.at(keyOf(request)).hulls;
}

std::vector<Hull> HullStore::fetch(const HullRequest& request) const {
  const std::vector<Vector3> points = scaledVertices(request);
  if (points.empty()) return {};
  const bool isCached = !cache_.folder().empty() && request.mesh->triangles.size() >= kFewTriangles;
  const std::string name = isCached ? fileNameOf(request) : "";
  if (isCached) {
    if (const std::optional<std::string> bytes = cache_.find(name)) {
      std::optional<std::vector<Hull>> hulls = decodeHulls(*bytes);
      if (hulls && fits(*hulls, boxOf(points))) {
        logger().debug(sentenceOf(request, hulls->size()) + ", from " + cache_.folder().string());
        return *std::move(hulls);
      }
    }
  }
  const auto begin = std::chrono::steady_clock::now();
  Hulls hulls = makeHulls(request, points);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  char text[32];
  std::snprintf(text, sizeof text, ", computed in %.2f s", taken.count());
  const std::string sentence = sentenceOf(request, hulls.all.size()) + text;
  if (!hulls.areComplete) {
    // not cached, so that each run says it
    logger().warning(
        sentenceOf(request, hulls.all.size()) +
        ", and so not as its real shape: its triangles are in such disorder that more pieces take too long");
    return std::move(hulls.all);
  }
  // not worth telling if it was quick and gave one piece
  hulls.all.size() > 1 ? logger().info(sentence) : logger().debug(sentence);
  if (isCached) keep(name, hulls.all);
  return std::move(hulls.all);
}

void HullStore::keep(const std::string& name, const std::vector<Hull>& hulls) const {
  const std::string problem = cache_.keep(name, encodeHulls(hulls));
  if (problem.empty()) return;
  logger().info("the pieces of meshes can't be cached in '" + cache_.folder().string() +
                "' and are computed again each time: " + problem);
}

}  // namespace pongsim::physics
