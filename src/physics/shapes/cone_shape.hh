#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

namespace pongsim::physics {

/// A cone centred on its origin, with its tip on z. Bullet's own cone grows by its margin; this one keeps its size, and
/// its edge and tip are rounded instead.
class ConeShape : public btConvexInternalShape {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// [m]
  ConeShape(btScalar radius, btScalar length);

  btVector3 localGetSupportingVertex(const btVector3& direction) const override;
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                         int count) const override;
  /// About the origin, not the centre of mass.
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
  const char* getName() const override { return "cone"; }

 private:
  btScalar radius_, length_;
  /// The cone all of whose surface is the margin further in.
  btScalar innerRadius_, innerTip_, innerBase_;
};

}  // namespace pongsim::physics
