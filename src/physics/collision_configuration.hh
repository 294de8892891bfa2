#pragma once

#include <BulletCollision/CollisionDispatch/btConvexPlaneCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

namespace pongsim::physics {

/// Bullet's own ways to find where shapes touch; but a plane has no end, and so is looked at from every piece of a mesh
/// in each step, for which a hull or box that is far above it is passed over. The points that are found stay the same.
class CollisionConfiguration final : public btDefaultCollisionConfiguration {
 public:
  /// A body on a plane finds all its corners in one step instead of one a step.
  CollisionConfiguration();

  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int typeA, int typeB) override;

 private:
  struct MakeHullOnPlane final : btConvexPlaneCollisionAlgorithm::CreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
  };

  MakeHullOnPlane hullOnPlane_;
  MakeHullOnPlane planeUnderHull_;
};

}  // namespace pongsim::physics
