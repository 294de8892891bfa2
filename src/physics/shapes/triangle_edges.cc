#include "physics/shapes/triangle_edges.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "base/hash.hh"
#include "physics/motion.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

using Corners = TriangleEdges::Corners;

// corners closer than a tenth of a millimetre are the same, squared; likewise for areas
constexpr double kSameDistance = 1e-4;
constexpr double kSamePlace = kSameDistance * kSameDistance;
// edge of the cells in which equal corners are looked for [m]
constexpr double kCell = 1e-3;
// of more triangles at one edge only the last ones are compared: they form no surface, and the cost stays n log n
constexpr std::ptrdiff_t kMostAtEdge = 256;
// squared sine of the angle below which a surface is flat
constexpr double kFlat = 1e-4;
// a contact further from an edge [m] does not belong to it
constexpr double kNearEdge = 0.1;

btVector3 normalOf(const btVector3& a, const btVector3& b, const btVector3& c) {
  return (b - a).cross(c - a).normalized();
}

double areaSquared(const Corners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).length2();
}

/// @return The direction in a triangle's plane that is perpendicular to one of its edges, towards its third corner.
btVector3 inwards(const btVector3& edge, const btVector3& normal, const btVector3& toThirdCorner) {
  const btVector3 across = edge.cross(normal).normalized();
  return across.dot(toThirdCorner) < 0 ? -across : across;
}

/// @return Distance of `point` from the line through the two others.
double distanceFrom(const btVector3& begin, const btVector3& end, const btVector3& point) {
  const btVector3 line = end - begin;
  if (line.fuzzyZero()) return (point - begin).length();
  const double part = std::clamp((point - begin).dot(line) / line.dot(line), 0.0, 1.0);
  return (point - (begin + line * part)).length();
}

/// The corners that two triangles share, as corner numbers in each.
struct SharedCorners {
  std::array<std::size_t, 2> own;
  std::array<std::size_t, 2> others;

  /// @return Nothing unless there are exactly two.
  static std::optional<SharedCorners> of(const Corners& own, const Corners& others) {
    SharedCorners shared{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if ((own[i] - others[j]).length2() >= kSamePlace) continue;
        if (count == 2) return std::nullopt;
        shared.own[count] = i;
        shared.others[count++] = j;
      }
    }
    if (count != 2 || shared.own[0] == shared.own[1] || shared.others[0] == shared.others[1]) return std::nullopt;
    // keep the order around the triangle
    if (shared.own[0] == 0 && shared.own[1] == 2) {
      std::swap(shared.own[0], shared.own[1]);
      std::swap(shared.others[0], shared.others[1]);
    }
    return shared;
  }
};

}  // namespace

/// The triangles' edges by the cells of their ends.
class TriangleEdges::Index {
 public:
  /// @param order The triangles' numbers; of several at one edge the last one in this order counts.
  Index(const std::vector<Corners>& triangles, const std::vector<std::uint32_t>& order) : triangles_(triangles) {
    entries_.reserve(3 * triangles.size());
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
      const Corners& corners = triangles[order[rank]];
      if (areaSquared(corners) < kSamePlace) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const btVector3 ends[2] = {corners[i], corners[(i + 1) % 3]};
        entries_.push_back({keyOf(cellOf(ends[0]), cellOf(ends[1])), rank, order[rank]});
      }
    }
    std::ranges::sort(entries_,
                      [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.rank < b.rank; });
  }

  /// @return What lies beyond an edge of a triangle.
  std::optional<Edge> beyond(std::uint32_t triangle, std::size_t edge) const {
    const Corners& corners = triangles_[triangle];
    if (areaSquared(corners) < kSamePlace) return std::nullopt;
    Found last;
    for (const btVector3& from : cellsNear(corners[edge])) {
      for (const btVector3& to : cellsNear(corners[(edge + 1) % 3])) lookIn(keyOf(from, to), triangle, edge, last);
    }
    return last.edge;
  }

 private:
  struct Entry {
    std::uint64_t key;
    std::uint32_t rank;
    std::uint32_t triangle;
  };
  struct Found {
    std::optional<Edge> edge = std::nullopt;
    std::uint32_t rank = 0;
  };

  void lookIn(std::uint64_t key, std::uint32_t triangle, std::size_t edge, Found& last) const {
    const auto [begin, end] = std::ranges::equal_range(entries_, key, {}, &Entry::key);
    for (auto entry = end; entry != begin && end - entry < kMostAtEdge;) {
      --entry;
      if (entry->triangle == triangle) continue;
      if (last.edge && entry->rank <= last.rank) return;
      const auto shared = SharedCorners::of(triangles_[triangle], triangles_[entry->triangle]);
      // the corner that is not shared tells which edge it is
      if (!shared || (4 - shared->own[0] - shared->own[1]) % 3 != edge) continue;
      last = {bendAt(triangles_[triangle], triangles_[entry->triangle], *shared), entry->rank};
      return;
    }
  }

  static Edge bendAt(const Corners& corners, const Corners& others, const SharedCorners& shared) {
    const auto& [own, theirs] = shared;
    const std::size_t third = 3 - own[0] - own[1], theirThird = 3 - theirs[0] - theirs[1];
    const btVector3 normal = normalOf(corners[0], corners[1], corners[2]);
    const btVector3 beyond = normalOf(others[theirs[1]], others[theirs[0]], others[theirThird]);
    const btVector3 edge = (corners[own[1]] - corners[own[0]]).normalized();
    const btVector3 side = inwards(edge, normal, corners[third] - corners[own[0]]);
    const btVector3 theirSide = inwards(edge, beyond, others[theirThird] - others[theirs[0]]);
    const btVector3 axis = side.cross(theirSide);
    Edge found{0, false, beyond};
    if (axis.length2() < kFlat) return found;
    const btVector3 square = axis.normalized().cross(side).normalized();
    const double angle = std::numbers::pi - math::atan2(theirSide.dot(square), theirSide.dot(side));
    found.isConvex = normal.dot(theirSide) < 0;
    found.angle = found.isConvex ? -angle : angle;
    return found;
  }

  // shifted: corners often lie at whole millimetres
  static btVector3 cellOf(const btVector3& point) {
    constexpr double kShift = 0.37;
    return {std::floor(point.x() / kCell + kShift), std::floor(point.y() / kCell + kShift),
            std::floor(point.z() / kCell + kShift)};
  }

  /// @return The cells, 1 to 8, in which the same corner of another triangle may be.
  static std::vector<btVector3> cellsNear(const btVector3& point) {
    const btVector3 reach(kSameDistance, kSameDistance, kSameDistance);
    const btVector3 lowest = cellOf(point - reach), highest = cellOf(point + reach);
    std::vector<btVector3> cells{lowest};
    for (int axis = 0; axis < 3; ++axis) {
      if (lowest[axis] == highest[axis]) continue;
      for (std::size_t i = 0, count = cells.size(); i < count; ++i) {
        btVector3 cell = cells[i];
        cell[axis] = highest[axis];
        cells.push_back(cell);
      }
    }
    return cells;
  }

  /// The same in both directions.
  static std::uint64_t keyOf(const btVector3& from, const btVector3& to) { return keyOf(from) + keyOf(to); }
  static std::uint64_t keyOf(const btVector3& cell) {
    base::Hash hash;
    for (int axis = 0; axis < 3; ++axis) hash.add(cell[axis]);
    return hash.value();
  }

  const std::vector<Corners>& triangles_;
  std::vector<Entry> entries_;
};

namespace {

/// Bullet's order of the triangles.
std::vector<std::uint32_t> orderIn(const btBvhTriangleMeshShape& shape) {
  struct Order final : btTriangleCallback {
    void processTriangle(btVector3* /*corners*/, int /*part*/, int index) override {
      numbers.push_back(static_cast<std::uint32_t>(index));
    }
    std::vector<std::uint32_t> numbers;
  };
  Order order;
  btVector3 lowest, highest;
  shape.getAabb(btTransform::getIdentity(), lowest, highest);
  shape.processAllTriangles(&order, lowest, highest);
  return order.numbers;
}

}  // namespace

void TriangleEdges::connect(btBvhTriangleMeshShape& shape, const std::vector<Corners>& triangles) {
  edges_.resize(triangles.size());
  const Index index(triangles, orderIn(shape));
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t edge = 0; edge < 3; ++edge) edges_[i][edge] = index.beyond(i, edge);
  }
  shape.setTriangleInfoMap(this);
}

void TriangleEdges::smooth(btManifoldPoint& point, const btCollisionObjectWrapper& triangle, int index) {
  const btCollisionShape& whole = *triangle.getCollisionObject()->getCollisionShape();
  if (whole.getShapeType() != TRIANGLE_MESH_SHAPE_PROXYTYPE) return;
  const auto* surface =
      static_cast<const TriangleEdges*>(static_cast<const btBvhTriangleMeshShape&>(whole).getTriangleInfoMap());
  if (surface == nullptr) return;
  const auto& corners = static_cast<const btTriangleShape&>(*triangle.getCollisionShape()).m_vertices1;
  const Edges& edges = surface->edges_[static_cast<std::size_t>(index)];
  std::size_t nearest = 3;
  double distance = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    const double own = distanceFrom(corners[i], corners[(i + 1) % 3], point.m_localPointB);
    if (!edges[i] || own >= distance) continue;
    nearest = i;
    distance = own;
  }
  if (nearest == 3 || distance >= kNearEdge) return;

  const Edge& beyond = *edges[nearest];
  const btMatrix3x3& R = triangle.getWorldTransform().getBasis();
  const btVector3 normal = (R.transpose() * point.m_normalWorldOnB).normalized();
  const btVector3 flat = normalOf(corners[0], corners[1], corners[2]);
  const btVector3 up = beyond.isConvex ? flat : -flat;
  btVector3 smoothed = flat.dot(normal) < 0 ? -flat : flat;
  const bool isAbove =
      normal.dot(up) >= 0 || normal.dot(beyond.isConvex ? beyond.normalBeyond : -beyond.normalBeyond) >= 0;
  if (beyond.angle != 0 && isAbove) {
    // a normal between those of both triangles stays; others become that of the neighbour
    const btVector3 edge = (corners[nearest] - corners[(nearest + 1) % 3]).normalized();
    const double angle = math::atan2(normal.dot(edge.cross(up).normalized()), normal.dot(up));
    if (beyond.angle < 0 ? angle >= beyond.angle : angle <= beyond.angle) return;
    smoothed = btMatrix3x3(turnAbout(edge, beyond.angle - angle)) * normal;
    if (smoothed.dot(flat) <= 0) return;
  }
  point.m_normalWorldOnB = R * smoothed;
  point.m_positionWorldOnB = point.m_positionWorldOnA - point.m_normalWorldOnB * point.m_distance1;
  point.m_localPointB = triangle.getWorldTransform().invXform(point.m_positionWorldOnB);
}

}  // namespace pongsim::physics
