#include "physics/hulls/triangle_chain.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "physics/hulls/chain_edges.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

using Triangle = TriangleChain::Triangle;
using Index = std::uint32_t;

/// A hole is closed if its cap is at most this part of the surface.
constexpr double kLargestHole = 0.05;
/// A body that fills a smaller part of its bounding box is a sheet with triangles on both sides.
constexpr double kSmallestFilling = 1e-6;

double areaOf(const TriangleChain& chain, const Triangle& t) {
  const Vector3& a = chain.points[t.a];
  return (chain.points[t.b] - a).cross(chain.points[t.c] - a).norm() / 2;
}

Eigen::AlignedBox3d boxOf(const TriangleChain& chain) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : chain.triangles)
    box.extend(chain.points[t.a]).extend(chain.points[t.b]).extend(chain.points[t.c]);
  return box;
}

/// Merges points in the same place.
/// @return The new number of each.
std::vector<Index> weld(std::vector<Vector3>& points) {
  std::vector<Index> order(points.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](Index i) { return std::tuple(points[i].x(), points[i].y(), points[i].z(), i); };
  std::ranges::sort(order, {}, key);
  std::vector<Index> first(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool isSame = k > 0 && points[order[k]] == points[order[k - 1]];
    first[order[k]] = isSame ? first[order[k - 1]] : order[k];
  }
  return first;
}

void dropFlat(TriangleChain& chain) {
  std::erase_if(chain.triangles,
                [&](const Triangle& t) { return t.a == t.b || t.b == t.c || t.c == t.a || !(areaOf(chain, t) > 0); });
}

/// Keeps one of several triangles with the same corners.
void dropDoubles(TriangleChain& chain) {
  const auto key = [](const Triangle& t) {
    std::array<Index, 3> corners{t.a, t.b, t.c};
    std::ranges::sort(corners);
    return corners;
  };
  std::ranges::stable_sort(chain.triangles, {}, key);
  const auto rest = std::ranges::unique(chain.triangles, {}, key);
  chain.triangles.erase(rest.begin(), rest.end());
}

/// @return The chain with its holes capped, if that makes it a body; else unchanged, a sheet.
/// @param isAny Whether large holes are closed too.
TriangleChain closed(TriangleChain chain, bool isAny) {
  TriangleChain body = chain;
  double surface = 0;
  for (const Triangle& t : chain.triangles) surface += areaOf(chain, t);
  for (const std::vector<DirectedEdge>& hole : connectedParts(boundaryOf(chain.triangles))) {
    const std::size_t before = body.triangles.size();
    addFan(hole, body.triangles);
    double area = 0;
    for (std::size_t i = before; i < body.triangles.size(); ++i) area += areaOf(body, body.triangles[i]);
    if (area > kLargestHole * surface && !isAny) return chain;
  }
  body.isClosed = true;
  const bool isBody = !chain.triangles.empty() && std::abs(volumeOf(body)) > kSmallestFilling * boxOf(body).volume();
  return isBody ? body : chain;
}

/// Removes points that no triangle uses.
void compact(TriangleChain& chain) {
  constexpr Index kNone = ~Index{0};
  std::vector<Index> place(chain.points.size(), kNone);
  std::vector<Vector3> points;
  for (Triangle& t : chain.triangles) {
    for (Index* corner : {&t.a, &t.b, &t.c}) {
      if (place[*corner] == kNone) {
        place[*corner] = static_cast<Index>(points.size());
        points.push_back(chain.points[*corner]);
      }
      *corner = place[*corner];
    }
  }
  chain.points = std::move(points);
}

/// @return The winding number of the chain around the point: its solid angle relative to the whole sphere, by the
/// formula of A. Van Oosterom and J. Strackee, The solid angle of a plane triangle, 1983.
double windingAround(const TriangleChain& chain, const Vector3& point) {
  double sum = 0;
  for (const Triangle& t : chain.triangles) {
    const Vector3 a = chain.points[t.a] - point, b = chain.points[t.b] - point, c = chain.points[t.c] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    sum += math::atan2(a.dot(b.cross(c)), below);
  }
  return sum / (2 * std::numbers::pi);
}

void turnRound(TriangleChain& chain) {
  for (Triangle& t : chain.triangles) std::swap(t.b, t.c);
}

void append(const TriangleChain& from, TriangleChain& to) {
  const auto first = static_cast<Index>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const Triangle& t : from.triangles) {
    to.triangles.push_back({first + t.a, first + t.b, first + t.c, t.isCap});
  }
}

/// @return The triangles grouped into parts that have no point in common.
std::vector<TriangleChain> partsOf(const TriangleChain& chain) {
  Sets sets(chain.points.size());
  for (const Triangle& t : chain.triangles) {
    sets.unite(t.a, t.b);
    sets.unite(t.b, t.c);
  }
  std::vector<TriangleChain> parts;
  std::unordered_map<std::size_t, std::size_t> numberOf;
  for (const Triangle& t : chain.triangles) {
    const auto [place, isNew] = numberOf.try_emplace(sets.rootOf(t.a), parts.size());
    if (isNew) parts.push_back({{}, {}, chain.isClosed});
    parts[place->second].triangles.push_back(t);
  }
  if (parts.size() < 2) return {chain};
  std::vector<Index> place(chain.points.size(), ~Index{0});
  for (TriangleChain& part : parts) {
    for (Triangle& t : part.triangles) {
      for (Index* corner : {&t.a, &t.b, &t.c}) {
        if (place[*corner] == ~Index{0}) {
          place[*corner] = static_cast<Index>(part.points.size());
          part.points.push_back(chain.points[*corner]);
        }
        *corner = place[*corner];
      }
    }
  }
  return parts;
}

}  // namespace

TriangleChain makeChain(const description::TriangleMesh& mesh, const Vector3& scale, bool closesAll) {
  TriangleChain chain;
  chain.points.reserve(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) chain.points.push_back(vertex.cwiseProduct(scale));
  const std::vector<Index> first = weld(chain.points);
  for (const auto& [a, b, c] : mesh.triangles) chain.triangles.push_back({first[a], first[b], first[c]});
  if (scale.prod() < 0) turnRound(chain);
  dropFlat(chain);
  compact(chain);

  // some meshes have each triangle on both sides, or mixed orientations: the variant with the fewest open edges wins
  TriangleChain best = closed(chain, closesAll);
  std::size_t fewest = best.isClosed ? boundaryOf(chain.triangles).size() : ~std::size_t{0};
  if (fewest == 0) return best;
  TriangleChain once = chain;
  dropDoubles(once);
  TriangleChain alike = once;
  orientAlike(alike.triangles);
  for (const TriangleChain* candidate : {&once, &alike}) {
    const std::size_t count = boundaryOf(candidate->triangles).size();
    TriangleChain made = count < fewest ? closed(*candidate, closesAll) : TriangleChain();
    if (!made.isClosed) continue;
    best = std::move(made);
    fewest = count;
  }
  return best;
}

void coarsen(TriangleChain& chain, std::size_t mostTriangles) {
  const Eigen::AlignedBox3d box = boxOf(chain);
  for (double cells = 200; chain.triangles.size() > mostTriangles && cells > 4; cells *= 0.7) {
    // this maps points to points, so what was closed stays closed
    const double edge = box.sizes().maxCoeff() / cells;
    std::unordered_map<std::uint64_t, Index> firstIn;
    std::vector<Index> first(chain.points.size());
    for (Index i = 0; i < chain.points.size(); ++i) {
      std::uint64_t cell = 0;
      for (int axis = 0; axis < 3; ++axis) {
        cell = cell << 20U | static_cast<std::uint64_t>((chain.points[i][axis] - box.min()[axis]) / edge);
      }
      first[i] = firstIn.try_emplace(cell, i).first->second;
    }
    for (Triangle& t : chain.triangles) t = {first[t.a], first[t.b], first[t.c], t.isCap};
    cancelOpposites(chain.triangles);
    dropFlat(chain);
    compact(chain);
  }
}

double volumeOf(const TriangleChain& chain) {
  if (!chain.isClosed || chain.triangles.empty()) return 0;
  const Vector3 middle = boxOf(chain).center();
  double sum = 0;
  for (const Triangle& t : chain.triangles) {
    sum += (chain.points[t.a] - middle).dot((chain.points[t.b] - middle).cross(chain.points[t.c] - middle));
  }
  return sum / 6;
}

std::vector<TriangleChain> separateBodies(TriangleChain chain) {
  std::vector<TriangleChain> parts = partsOf(chain);
  if (!chain.isClosed) return {std::move(chain)};
  std::vector<TriangleChain> bodies, hollows;
  for (TriangleChain& part : parts) (volumeOf(part) >= 0 ? bodies : hollows).push_back(std::move(part));
  const std::size_t solid = bodies.size();
  for (TriangleChain& hollow : hollows) {
    // the smallest body around it; a cavity may touch a cut, where its winding number is one half
    constexpr double kWithin = 0.25;
    const Eigen::AlignedBox3d box = boxOf(hollow);
    std::size_t holder = solid;
    for (std::size_t i = 0; i < solid; ++i) {
      const bool mayHold = boxOf(bodies[i]).intersects(box) && volumeOf(bodies[i]) > -volumeOf(hollow);
      if (!mayHold || windingAround(bodies[i], hollow.points[0] * (1 - 1e-9) + box.center() * 1e-9) < kWithin) continue;
      if (holder == solid || volumeOf(bodies[i]) < volumeOf(bodies[holder])) holder = i;
    }
    if (holder == solid) {
      turnRound(hollow);
      bodies.push_back(std::move(hollow));
    } else {
      append(hollow, bodies[holder]);
    }
  }
  return bodies;
}

}  // namespace pongsim::physics
