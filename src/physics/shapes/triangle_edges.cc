#include "physics/shapes/triangle_edges.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "physics/motion.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

using Corners = TriangleEdges::Corners;

// corners closer than a tenth of a millimetre are the same, squared; likewise for areas
constexpr double kSamePlace = 1e-4 * 1e-4;
// squared sine of the angle below which a surface is flat
constexpr double kFlat = 1e-4;
// a contact further from an edge [m] does not belong to it
constexpr double kNearEdge = 0.1;

btVector3 normalOf(const btVector3& a, const btVector3& b, const btVector3& c) {
  return (b - a).cross(c - a).normalized();
}

double areaSquared(const btVector3* corners) {
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
  static std::optional<SharedCorners> of(const Corners& own, const btVector3* others) {
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
    if (count != 2) return std::nullopt;
    // keep the order around the triangle
    if (shared.own[0] == 0 && shared.own[1] == 2) {
      std::swap(shared.own[0], shared.own[1]);
      std::swap(shared.others[0], shared.others[1]);
    }
    return shared;
  }
};

}  // namespace

/// Called with every triangle that may be adjacent to a given one.
class TriangleEdges::Connector final : public btTriangleCallback {
 public:
  Connector(const Corners& corners, int index, Edges& edges) : corners_(corners), index_(index), edges_(edges) {}

  void processTriangle(btVector3* others, int /*part*/, int index) override {
    if (index == index_ || areaSquared(others) < kSamePlace || areaSquared(corners_.data()) < kSamePlace) return;
    const auto shared = SharedCorners::of(corners_, others);
    if (!shared) return;
    const auto& [own, theirs] = *shared;
    const std::size_t third = 3 - own[0] - own[1], theirThird = 3 - theirs[0] - theirs[1];
    const btVector3 normal = normalOf(corners_[0], corners_[1], corners_[2]);
    const btVector3 beyond = normalOf(others[theirs[1]], others[theirs[0]], others[theirThird]);
    const btVector3 edge = (corners_[own[1]] - corners_[own[0]]).normalized();
    const btVector3 side = inwards(edge, normal, corners_[third] - corners_[own[0]]);
    const btVector3 theirSide = inwards(edge, beyond, others[theirThird] - others[theirs[0]]);
    const btVector3 axis = side.cross(theirSide);
    Edge found{0, false, beyond};
    if (axis.length2() >= kFlat) {
      const btVector3 square = axis.normalized().cross(side).normalized();
      const double angle = std::numbers::pi - math::atan2(theirSide.dot(square), theirSide.dot(side));
      found.isConvex = normal.dot(theirSide) < 0;
      found.angle = found.isConvex ? -angle : angle;
    }
    // the corner that is not shared tells which edge it is
    edges_[(third + 1) % 3] = found;
  }

 private:
  const Corners& corners_;
  int index_;
  Edges& edges_;
};

void TriangleEdges::connect(btBvhTriangleMeshShape& shape, const std::vector<Corners>& triangles) {
  edges_.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    btVector3 lowest = triangles[i][0], highest = lowest;
    for (const btVector3& corner : triangles[i]) {
      lowest.setMin(corner);
      highest.setMax(corner);
    }
    Connector connector(triangles[i], static_cast<int>(i), edges_[i]);
    shape.processAllTriangles(&connector, lowest, highest);
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
