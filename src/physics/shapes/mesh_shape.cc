#include "physics/shapes/mesh_shape.hh"

#include <vector>

#include "physics/convert.hh"

namespace pongsim::physics {

TriangleSurface::TriangleSurface(const description::TriangleMesh& mesh, const Vector3& scale, const Pose& X_BodyMesh) {
  std::vector<Vector3> vertices;
  std::vector<TriangleEdges::Corners> corners;
  vertices.reserve(mesh.vertices.size());
  triangles_.preallocateVertices(static_cast<int>(mesh.vertices.size()));
  triangles_.preallocateIndices(static_cast<int>(3 * mesh.triangles.size()));
  for (const Vector3& vertex : mesh.vertices) {
    vertices.push_back(X_BodyMesh * vertex.cwiseProduct(scale));
    triangles_.findOrAddVertex(toBullet(vertices.back()), false);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    // a triangle without area has no side to push to
    if ((vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).isZero(0)) continue;
    triangles_.addTriangleIndices(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
    corners.push_back({toBullet(vertices[a]), toBullet(vertices[b]), toBullet(vertices[c])});
  }
  if (triangles_.getNumTriangles() == 0) return;
  shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
  shape_->setMargin(0);
  edges_.connect(*shape_, corners);
}

}  // namespace pongsim::physics
