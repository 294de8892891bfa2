#include "physics/contacts/surface.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>

#include "description/link.hh"
#include "physics/shapes/shape.hh"
#include "physics/shapes/triangle_edges.hh"

namespace pongsim::physics {

const btCollisionShape* partOf(const btCollisionObjectWrapper* wrapper) {
  for (; wrapper != nullptr; wrapper = wrapper->m_parent) {
    if (wrapper->getCollisionShape()->getUserPointer() != nullptr) return wrapper->getCollisionShape();
  }
  return nullptr;
}

const description::Surface& surfaceOf(const btCollisionShape& part) {
  return *static_cast<const description::Surface*>(part.getUserPointer());
}

namespace {

/// @return The surface of a collision, changed or as in the file.
const description::Surface& surfaceNow(const btCollisionObject& object, const btCollisionShape& part) {
  // the shape is far from what contact detection has read
  if (!LinkShape::hasChangedSurface(object)) return surfaceOf(part);
  const auto* shape = static_cast<const LinkShape*>(object.getUserPointer());
  return *shape->part(static_cast<std::size_t>(part.getUserIndex())).surface;
}

bool combine(btManifoldPoint& point, const btCollisionObjectWrapper* wrapperA, int /*partA*/, int /*indexA*/,
             const btCollisionObjectWrapper* wrapperB, int /*partB*/, int indexB) {
  const btCollisionShape* a = partOf(wrapperA);
  const btCollisionShape* b = partOf(wrapperB);
  if (a == nullptr || b == nullptr) return false;
  if (wrapperB->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE) {
    TriangleEdges::smooth(point, *wrapperB, indexB);
  }
  const description::Surface& one = surfaceNow(*wrapperA->getCollisionObject(), *a);
  const description::Surface& other = surfaceNow(*wrapperB->getCollisionObject(), *b);
  point.m_combinedFriction = std::min(one.mu, other.mu);
  point.m_combinedRestitution = one.restitution * other.restitution;
  // numbers of the collisions in their links; Bullet leaves a triangle's number here, or nothing
  point.m_index0 = a->getUserIndex();
  point.m_index1 = b->getUserIndex();
  return true;
}

}  // namespace

void combineSurfacesAsFortress() {
  static const bool installed = [] {
    gContactAddedCallback = combine;
    return true;
  }();
  static_cast<void>(installed);
}

}  // namespace pongsim::physics
