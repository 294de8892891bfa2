#pragma once

#include <BulletCollision/CollisionDispatch/btConvexPlaneCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

namespace pongsim::physics {

/// Bullet's own ways to find where shapes touch, but for planes. A plane has no end, and so is looked at from every
/// piece of a mesh in each step, for which a hull or box that is far above it is passed over. And a body on it is
/// tilted a little with sines that are the same on every machine. The points that are found stay the same. Bullet's
/// memory pools are left empty: the dispatcher has an arena.
class CollisionConfiguration final : public btDefaultCollisionConfiguration {
 public:
  CollisionConfiguration();

  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int typeA, int typeB) override;

 private:
  struct MakeConvexOnPlane final : btConvexPlaneCollisionAlgorithm::CreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
  };

  MakeConvexOnPlane convexOnPlane_;
  MakeConvexOnPlane planeUnderConvex_;
};

}  // namespace pongsim::physics
