#pragma once

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include <memory>

#include "description/triangle_mesh.hh"
#include "physics/shapes/triangle_edges.hh"
#include "pongsim/types.hh"

namespace pongsim::physics {

/// The triangles of a mesh, for a body that does not move. Bodies that slide over them do not catch on the edges
/// between triangles, if this is the only part of its body.
class TriangleSurface {
 public:
  /// @param X_BodyMesh The shape's points are given in the body frame.
  TriangleSurface(const description::TriangleMesh& mesh, const Vector3& scale, const Pose& X_BodyMesh);
  TriangleSurface(const TriangleSurface&) = delete;
  TriangleSurface& operator=(const TriangleSurface&) = delete;

  /// @return Null if no triangle has an area.
  btCollisionShape* shape() { return shape_.get(); }
  int triangleCount() const { return triangles_.getNumTriangles(); }

 private:
  btTriangleMesh triangles_;
  TriangleEdges edges_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

}  // namespace pongsim::physics
