#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <array>
#include <optional>
#include <vector>

namespace pongsim::physics {

/// How the triangles of a surface continue beyond their edges, so that sliding bodies do not catch there. Bullet's
/// btInternalEdgeUtility does the same with sines and angles of the C library.
class TriangleEdges final : public btTriangleInfoMap {
 public:
  using Corners = std::array<btVector3, 3>;

  /// Finds adjacent triangles, and attaches this to the shape.
  /// @param triangles The shape's triangles, in its order. This must outlive the shape.
  void connect(btBvhTriangleMeshShape& shape, const std::vector<Corners>& triangles);

  /// Turns a contact's normal to that of a surface without inner edges.
  /// @param triangle The colliding triangle, as part B of the contact. Does nothing if its body has more than one
  /// shape.
  static void smooth(btManifoldPoint& point, const btCollisionObjectWrapper& triangle, int index);

 private:
  struct Edge {
    /// Angle by which the surface bends there, up or down [rad]; 0: flat.
    double angle;
    bool isConvex;
    /// The normal of the adjacent triangle.
    btVector3 normalBeyond;
  };
  /// Edges from the first corner to the second, to the third, and back; empty where no triangle is adjacent.
  using Edges = std::array<std::optional<Edge>, 3>;
  class Index;

  std::vector<Edges> edges_;
};

}  // namespace pongsim::physics
