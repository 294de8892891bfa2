#include "physics/shapes/cone_shape.hh"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <algorithm>

#include "physics/shapes/margin.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

ConeShape::ConeShape(btScalar radius, btScalar length) : radius_(radius), length_(length) {
  m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  // of half the angle at the tip
  const btScalar sine = radius / math::hypot(radius, length);
  // so small that rounding takes at most the usual margin off the tip
  setMargin(sine * marginFor(std::min(radius, length / 2)));
  innerBase_ = -length / 2 + getMargin();
  innerTip_ = length / 2 - getMargin() / sine;
  innerRadius_ = radius * (innerTip_ - innerBase_) / length;
}

btVector3 ConeShape::localGetSupportingVertex(const btVector3& direction) const {
  const btScalar length = direction.length();
  const btVector3 unit = length > 0 ? direction / length : btVector3(1, 0, 0);
  return localGetSupportingVertexWithoutMargin(unit) + getMargin() * unit;
}

btVector3 ConeShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  // the tip, or the point of the base circle on the side of the direction
  const btScalar across = math::hypot(direction.x(), direction.y());
  if (direction.z() * (innerTip_ - innerBase_) > across * innerRadius_) return {0, 0, innerTip_};
  if (across > 0) {
    return {innerRadius_ * direction.x() / across, innerRadius_ * direction.y() / across, innerBase_};
  }
  return {innerRadius_, 0, innerBase_};
}

void ConeShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                                  int count) const {
  for (int i = 0; i < count; ++i) supports[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void ConeShape::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
  const btScalar across = mass * (3 * radius_ * radius_ / 20 + length_ * length_ / 10);
  inertia = btVector3(across, across, mass * 3 * radius_ * radius_ / 10);
}

}  // namespace pongsim::physics
