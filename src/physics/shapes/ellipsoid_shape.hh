#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

namespace pongsim::physics {

/// An ellipsoid centred on its frame's origin, a shape that Bullet lacks.
class EllipsoidShape : public btConvexInternalShape {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// @param radii Along x, y, z [m].
  explicit EllipsoidShape(const btVector3& radii);

  btVector3 localGetSupportingVertex(const btVector3& direction) const override;
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                         int count) const override;
  /// @param inertia Set to that of a solid ellipsoid of this mass [kg m^2].
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
  void getAabb(const btTransform& X_WorldShape, btVector3& lower, btVector3& upper) const override;
  const char* getName() const override { return "ellipsoid"; }

 private:
  btVector3 radii_;
};

}  // namespace pongsim::physics
