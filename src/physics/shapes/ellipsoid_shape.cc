#include "physics/shapes/ellipsoid_shape.hh"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include "physics/shapes/margin.hh"

namespace pongsim::physics {

EllipsoidShape::EllipsoidShape(const btVector3& radii) : radii_(radii) {
  m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  setMargin(marginFor(radii[radii.minAxis()]));
}

btVector3 EllipsoidShape::localGetSupportingVertex(const btVector3& direction) const {
  // with S = diag(radii), the outermost point along d is S S d / |S d|
  const btVector3 scaled = radii_ * direction;
  const btScalar length = scaled.length();
  return length > 0 ? radii_ * scaled / length : btVector3(radii_.x(), 0, 0);
}

btVector3 EllipsoidShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  const btScalar length = direction.length();
  const btVector3 unit = length > 0 ? direction / length : btVector3(1, 0, 0);
  return localGetSupportingVertex(unit) - getMargin() * unit;
}

void EllipsoidShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                                       int count) const {
  for (int i = 0; i < count; ++i) supports[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void EllipsoidShape::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
  const btVector3 squares = radii_ * radii_;
  inertia = mass / 5 * btVector3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
}

void EllipsoidShape::getAabb(const btTransform& X_WorldShape, btVector3& lower, btVector3& upper) const {
  const btMatrix3x3& rotation = X_WorldShape.getBasis();
  btVector3 extent;
  for (int i = 0; i < 3; ++i) extent[i] = (rotation[i] * radii_).length();
  lower = X_WorldShape.getOrigin() - extent;
  upper = X_WorldShape.getOrigin() + extent;
}

}  // namespace pongsim::physics
