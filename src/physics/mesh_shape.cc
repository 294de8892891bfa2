#include "physics/mesh_shape.hh"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <LinearMath/btConvexHullComputer.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "physics/convert.hh"
#include "physics/margin.hh"

namespace pongsim::physics {

namespace {

/// Finding what touches a hull takes time with each of its corners: of more, only some are kept.
constexpr std::size_t kMostCorners = 500;
/// Making a hull takes time with each point: of more, only the outermost in so many directions are looked at.
constexpr std::size_t kMostPoints = 5000;
constexpr std::size_t kDirections = 2000;

/// @return The points that lie outermost in one of so many directions, which are spread evenly (a Fibonacci lattice).
std::vector<btVector3> outermost(const std::vector<btVector3>& points, std::size_t directions) {
  std::set<std::size_t> kept;
  for (std::size_t i = 0; i < directions; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(directions);
    const double radius = std::sqrt(1 - z * z);
    const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5));
    const btVector3 direction(radius * std::cos(angle), radius * std::sin(angle), z);
    std::size_t best = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
      if (direction.dot(points[k]) > direction.dot(points[best])) best = k;
    }
    kept.insert(best);
  }
  std::vector<btVector3> outer;
  for (const std::size_t index : kept) outer.push_back(points[index]);
  return outer;
}

/// @param margin How far the faces draw back inwards; less where there is no room.
std::vector<btVector3> cornersOf(const std::vector<btVector3>& points, double margin) {
  btConvexHullComputer computer;
  computer.compute(&points[0].x(), sizeof(btVector3), static_cast<int>(points.size()), margin, 1);
  std::vector<btVector3> corners;
  for (int i = 0; i < computer.vertices.size(); ++i) corners.push_back(computer.vertices[i]);
  return corners;
}

}  // namespace

std::unique_ptr<btCollisionShape> makeHull(const description::TriangleMesh& mesh, const Vector3& scale) {
  Eigen::AlignedBox3d box;
  std::vector<btVector3> points;
  points.reserve(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) {
    const Vector3 scaled = vertex.cwiseProduct(scale);
    box.extend(scaled);
    points.push_back(toBullet(scaled));
  }
  if (points.size() > kMostPoints) points = outermost(points, kDirections);

  // Bullet adds the margin to a hull: the faces draw back by as much first
  const double margin = marginFor(box.sizes().minCoeff() / 2);
  std::vector<btVector3> corners = cornersOf(points, margin);
  if (corners.size() > kMostCorners) corners = outermost(corners, kMostCorners);

  auto hull = std::make_unique<btConvexHullShape>();
  for (const btVector3& corner : corners) hull->addPoint(corner, false);
  hull->setMargin(margin);
  hull->recalcLocalAabb();
  return hull;
}

TriangleSurface::TriangleSurface(const description::TriangleMesh& mesh, const Vector3& scale, const Pose& X_BodyMesh) {
  std::vector<Vector3> vertices;
  vertices.reserve(mesh.vertices.size());
  triangles_.preallocateVertices(static_cast<int>(mesh.vertices.size()));
  triangles_.preallocateIndices(static_cast<int>(3 * mesh.triangles.size()));
  for (const Vector3& vertex : mesh.vertices) {
    vertices.push_back(X_BodyMesh * vertex.cwiseProduct(scale));
    triangles_.findOrAddVertex(toBullet(vertices.back()), false);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    // one without an area has no side to push to
    if ((vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).isZero(0)) continue;
    triangles_.addTriangleIndices(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
  }
  if (triangles_.getNumTriangles() == 0) return;
  shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
  shape_->setMargin(0);
  btGenerateInternalEdgeInfo(shape_.get(), &edges_);
}

}  // namespace pongsim::physics
