#pragma once

#include <BulletCollision/CollisionDispatch/btConvexPlaneCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

namespace pongsim::physics {

/// Bullet's collision algorithms, with our own for planes. A plane is infinite and so is tested against every piece of
/// a mesh in each step; a hull or box far above it is skipped. Bodies on a plane are tilted slightly with sines that
/// are the same on every machine. The contact points are the same as Bullet's. Bullet's memory pools stay
/// empty, because the dispatcher has an arena.
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
