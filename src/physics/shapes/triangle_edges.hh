#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <array>
#include <optional>
#include <vector>

namespace pongsim::physics {

/// How the triangles of a surface go on beyond their edges, so that what slides over them does not catch there. Bullet
/// has the same (btInternalEdgeUtility), with sines and angles of the C library.
class TriangleEdges final : public btTriangleInfoMap {
 public:
  using Corners = std::array<btVector3, 3>;

  /// Finds who lies beside whom, and lets the shape know.
  /// @param triangles Those of the shape, in its order. This must outlive the shape.
  void connect(btBvhTriangleMeshShape& shape, const std::vector<Corners>& triangles);

  /// Turns the normal of a point of contact to where a surface without edges would have it.
  /// @param triangle Which touches, as part B of the contact. Nothing happens where its body is of more than one shape.
  static void smooth(btManifoldPoint& point, const btCollisionObjectWrapper& triangle, int index);

 private:
  struct Edge {
    /// By how much the surface turns there, up or down [rad]; 0: it goes straight on.
    double angle;
    bool isConvex;
    /// The normal of the triangle beyond.
    btVector3 normalBeyond;
  };
  /// From its first corner to its second, to the third, and back; without those where nobody is beyond.
  using Edges = std::array<std::optional<Edge>, 3>;
  class Connector;

  std::vector<Edges> edges_;
};

}  // namespace pongsim::physics
