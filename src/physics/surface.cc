#include "physics/surface.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>

#include "description/link.hh"

namespace pongsim::physics {

namespace {

/// @return The surface of the part that is in touch, also where it is a part of a compound, or a triangle of a part.
const description::Surface* surfaceOf(const btCollisionObjectWrapper* wrapper) {
  for (; wrapper != nullptr; wrapper = wrapper->m_parent) {
    const void* const surface = wrapper->getCollisionShape()->getUserPointer();
    if (surface != nullptr) return static_cast<const description::Surface*>(surface);
  }
  return nullptr;
}

bool combine(btManifoldPoint& point, const btCollisionObjectWrapper* wrapperA, int /*partA*/, int /*indexA*/,
             const btCollisionObjectWrapper* wrapperB, int partB, int indexB) {
  const description::Surface* a = surfaceOf(wrapperA);
  const description::Surface* b = surfaceOf(wrapperB);
  if (a == nullptr || b == nullptr) return false;
  if (wrapperB->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE) {
    btAdjustInternalEdgeContacts(point, wrapperB, wrapperA, partB, indexB, BT_TRIANGLE_CONCAVE_DOUBLE_SIDED);
  }
  point.m_combinedFriction = std::min(a->mu, b->mu);
  point.m_combinedRestitution = a->restitution * b->restitution;
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
