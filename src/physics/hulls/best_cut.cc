#include "physics/hulls/best_cut.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "physics/hulls/chain_edges.hh"

namespace pongsim::physics {

namespace {

using Triangle = TriangleChain::Triangle;

/// How many planes along re-entrant edges are tried, and how many across each axis.
constexpr std::size_t kEdgePlanes = 12;
constexpr int kAxisPlanes = 9;
/// A plane does not cut if one of its sides has less than this part of the whole [1].
constexpr double kThinnest = 1e-3;
/// For a rough first estimate, hulls with more points are reduced to the outermost in this many directions; then this
/// many planes get a closer look.
constexpr std::size_t kRoughDirections = 48;
constexpr std::size_t kCloserLooks = 4;
/// Weights of a plane's cost. The excess volume of a hull counts down to half if the hull is small, because small hulls
/// can be cut better later. A plane without re-entrant edges costs a quarter of the excess more. Between equally good
/// planes, the one that cuts in half wins.
constexpr double kSizeCounts = 0.5;
constexpr double kEdgesCount = 0.25;
constexpr double kBalance = 0.005;

Eigen::AlignedBox3d boxAround(const TriangleChain& chain) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : chain.points) box.extend(point);
  return box;
}

Vector3 normalOf(const TriangleChain& chain, const Triangle& t) {
  const Vector3& a = chain.points[t.a];
  return (chain.points[t.b] - a).cross(chain.points[t.c] - a).stableNormalized();
}

std::uint32_t thirdCorner(const Triangle& t, const DirectedEdge& edge) {
  for (const std::uint32_t corner : {t.a, t.b}) {
    if (corner != edge.from && corner != edge.to) return corner;
  }
  return t.c;
}

/// Merges planes that are nearly the same; each is weighted by the length of the edges that vote for it.
class PlaneVotes {
 public:
  PlaneVotes(const Vector3& middle, double size) : middle_(middle), size_(size) {}

  void add(Vector3 normal, const Vector3& point, double weight) {
    // its orientation does not matter
    int first = 0;
    normal.cwiseAbs().maxCoeff(&first);
    if (normal[first] < 0) normal = -normal;
    const double distance = normal.dot(point - middle_) / size_;
    std::uint64_t key = 0;
    for (const double value : {normal.x() * 50, normal.y() * 50, normal.z() * 50, distance * 200}) {
      key = key << 16U | (static_cast<std::uint64_t>(std::llround(value)) & 0xffffU);
    }
    const auto [place, isNew] = places_.try_emplace(key, votes_.size());
    if (isNew) votes_.push_back({{normal, normal.dot(point)}, 0});
    votes_[place->second].weight += weight;
  }

  /// @return Those with the largest weights.
  std::vector<Plane> best(std::size_t count) {
    std::ranges::stable_sort(votes_, [](const Vote& a, const Vote& b) { return a.weight > b.weight; });
    std::vector<Plane> planes;
    for (const Vote& vote : votes_) {
      if (planes.size() < count) planes.push_back(vote.plane);
    }
    return planes;
  }

 private:
  struct Vote {
    Plane plane;
    double weight;
  };

  const Vector3 middle_;
  const double size_;
  std::unordered_map<std::uint64_t, std::size_t> places_;
  std::vector<Vote> votes_;
};

/// An edge at which a body is not convex, or any edge of a sheet.
struct Reentrant {
  Vector3 from, to;
  /// Normals of the two adjacent triangles.
  Vector3 normal1, normal2;
  /// Its length times the sine of its angle [m].
  double weight;
};

std::vector<Reentrant> reentrantEdges(const TriangleChain& chain) {
  std::vector<Reentrant> edges;
  for (const Neighbours& pair : neighboursIn(chain.triangles)) {
    const Triangle &one = chain.triangles[pair.one], &other = chain.triangles[pair.other];
    if (pair.areTwisted) continue;
    const Vector3 n1 = normalOf(chain, one), n2 = normalOf(chain, other);
    const Vector3& at = chain.points[pair.edge.from];
    const Vector3 along = chain.points[pair.edge.to] - at;
    const Vector3 across = chain.points[thirdCorner(other, pair.edge)] - at;
    // flatter edges are facets of a round surface
    constexpr double kSmallestSine = 0.02;
    const double sine = n1.cross(n2).norm();
    const bool isReentrant = n1.dot(across) > 0;
    if ((chain.isClosed && !isReentrant) || sine < kSmallestSine) continue;
    edges.push_back({at, chain.points[pair.edge.to], n1, n2, along.norm() * sine});
  }
  return edges;
}

std::vector<Plane> planesAlongEdges(const std::vector<Reentrant>& edges, const Vector3& middle, double size) {
  PlaneVotes faces(middle, size), between(middle, size);
  for (const Reentrant& edge : edges) {
    faces.add(edge.normal1, edge.from, edge.weight);
    faces.add(edge.normal2, edge.from, edge.weight);
    const Vector3 middleOfBoth = (edge.to - edge.from).cross(edge.normal1 + edge.normal2);
    if (middleOfBoth.norm() > 0) between.add(middleOfBoth.normalized(), edge.from, edge.weight);
  }
  std::vector<Plane> planes = faces.best(kEdgePlanes);
  const std::vector<Plane> others = between.best(kEdgePlanes / 2);
  planes.insert(planes.end(), others.begin(), others.end());
  return planes;
}

std::vector<Plane> planesAcrossAxes(const Eigen::AlignedBox3d& box) {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 1; i <= kAxisPlanes; ++i) {
      const double place = box.min()[axis] + box.sizes()[axis] * i / (kAxisPlanes + 1);
      planes.push_back({Vector3::Unit(axis), place});
    }
  }
  return planes;
}

/// Rates planes.
class Judge {
 public:
  Judge(const TriangleChain& chain, const ConvexHull& hull, const std::vector<Reentrant>& edges, double tolerance)
      : chain_(chain), hull_(hull), edges_(edges), tolerance_(tolerance) {
    const Eigen::AlignedBox3d box = boxAround(chain);
    middle_ = box.center();
    size_ = box.diagonal().norm();
    for (const Reentrant& edge : edges) edgeWeight_ += edge.weight;
    excess_ = hull.volume - (chain.isClosed ? volumeOf(chain) : 0);
  }

  bool cuts(const Plane& plane) const {
    double lowest = 0, highest = 0;
    for (const Vector3& corner : hull_.corners) {
      const double height = plane.normal.dot(corner) - plane.distance;
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    return std::min(-lowest, highest) > std::max(2 * tolerance_, kThinnest * (highest - lowest));
  }

  /// @return The excess volume of both hulls over the body, weighted as said above [m^3].
  double cost(const Plane& plane, bool isRough) const {
    const Halves halves = cut(chain_, plane, tolerance_, false);
    // seen from a point in the plane, the caps of the cut have no volume
    const Vector3 eye = middle_ - (plane.normal.dot(middle_) - plane.distance) * plane.normal;
    double sum = 0;
    std::array<double, 2> hullVolumes{};
    std::size_t i = 0;
    for (const TriangleChain* half : {&halves.front, &halves.back}) {
      if (half->triangles.empty()) return hull_.volume * 2;
      const double volume = chain_.isClosed ? volumeSeenFrom(*half, eye) : 0;
      hullVolumes[i] = hullVolume(half->points, isRough);
      const double size = boxAround(*half).diagonal().norm() / size_;
      sum += std::max(0.0, hullVolumes[i] - volume) * (1 - kSizeCounts + kSizeCounts * size);
      ++i;
    }
    return sum + kEdgesCount * excess_ * (1 - shareOfEdgesIn(plane)) +
           kBalance * std::abs(hullVolumes[0] - hullVolumes[1]);
  }

 private:
  double shareOfEdgesIn(const Plane& plane) const {
    const auto isIn = [&](const Vector3& point) {
      return std::abs(plane.normal.dot(point) - plane.distance) <= 2 * tolerance_;
    };
    double sum = 0;
    for (const Reentrant& edge : edges_) {
      if (isIn(edge.from) && isIn(edge.to)) sum += edge.weight;
    }
    return edgeWeight_ > 0 ? sum / edgeWeight_ : 0;
  }

  static double volumeSeenFrom(const TriangleChain& half, const Vector3& eye) {
    double sum = 0;
    for (const Triangle& t : half.triangles) {
      sum += (half.points[t.a] - eye).dot((half.points[t.b] - eye).cross(half.points[t.c] - eye));
    }
    return sum / 6;
  }

  static double hullVolume(const std::vector<Vector3>& points, bool isRough) {
    if (!isRough || points.size() <= 2 * kRoughDirections) return convexHull(points).volume;
    return convexHull(outermost(points, kRoughDirections)).volume;
  }

  const TriangleChain& chain_;
  const ConvexHull& hull_;
  const std::vector<Reentrant>& edges_;
  const double tolerance_;
  Vector3 middle_;
  double size_ = 0;
  double edgeWeight_ = 0;
  double excess_ = 0;
};

}  // namespace

double cutTolerance(const TriangleChain& chain) { return 5e-6 * boxAround(chain).sizes().maxCoeff(); }

std::optional<Plane> bestCut(const TriangleChain& chain, const ConvexHull& hull) {
  const Eigen::AlignedBox3d box = boxAround(chain);
  const std::vector<Reentrant> edges = reentrantEdges(chain);
  const Judge judge(chain, hull, edges, cutTolerance(chain));
  struct Candidate {
    Plane plane;
    double cost;
  };
  std::vector<Candidate> candidates;
  const auto consider = [&](const std::vector<Plane>& planes) {
    for (const Plane& plane : planes) {
      if (judge.cuts(plane)) candidates.push_back({plane, judge.cost(plane, true)});
    }
  };
  consider(planesAlongEdges(edges, box.center(), box.sizes().maxCoeff()));
  consider(planesAcrossAxes(box));
  const auto isBetter = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
  std::ranges::stable_sort(candidates, isBetter);
  candidates.resize(std::min(candidates.size(), kCloserLooks));
  for (Candidate& candidate : candidates) candidate.cost = judge.cost(candidate.plane, false);
  const auto best = std::ranges::min_element(candidates, isBetter);
  if (best == candidates.end()) return std::nullopt;
  return best->plane;
}

}  // namespace pongsim::physics
