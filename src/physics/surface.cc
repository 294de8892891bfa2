#include "physics/surface.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>

#include "description/link.hh"

namespace pongsim::physics {

namespace {

/// @return The surface of the part that is in touch, also where it is a part of a compound.
const description::Surface* surfaceOf(const btCollisionObjectWrapper* wrapper) {
  return static_cast<const description::Surface*>(wrapper->getCollisionShape()->getUserPointer());
}

bool combine(btManifoldPoint& point, const btCollisionObjectWrapper* wrapperA, int /*partA*/, int /*indexA*/,
             const btCollisionObjectWrapper* wrapperB, int /*partB*/, int /*indexB*/) {
  const description::Surface* a = surfaceOf(wrapperA);
  const description::Surface* b = surfaceOf(wrapperB);
  if (a == nullptr || b == nullptr) return false;
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
