#include "physics/dispatcher.hh"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "description/link.hh"
#include "physics/surface.hh"

namespace pongsim::physics {

namespace {

int partNumber(const btCollisionObjectWrapper* wrapper) {
  const btCollisionShape* part = partOf(wrapper);
  return part == nullptr ? -1 : part->getUserIndex();
}

/// @return Whether the masks of the two collisions share a bit; true where a whole of several is meant.
bool masksMeet(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) {
  const btCollisionShape* partA = partOf(a);
  const btCollisionShape* partB = partOf(b);
  if (partA == nullptr || partB == nullptr) return true;
  return (surfaceOf(*partA).collideBitmask & surfaceOf(*partB).collideBitmask) != 0;
}

}  // namespace

btCollisionAlgorithm* Dispatcher::findAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                                btPersistentManifold* shared, ebtDispatcherQueryType type) {
  if (!masksMeet(a, b)) return noAlgorithm(a, b, shared);
  lastA_ = a->getCollisionObject();
  lastPartA_ = partNumber(a);
  lastPartB_ = partNumber(b);
  return btCollisionDispatcher::findAlgorithm(a, b, shared, type);
}

btCollisionAlgorithm* Dispatcher::noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                              btPersistentManifold* shared) {
  btCollisionAlgorithmConstructionInfo info;
  info.m_dispatcher1 = this;
  info.m_manifold = shared;
  return m_doubleDispatchContactPoints[EMPTY_SHAPE_PROXYTYPE][EMPTY_SHAPE_PROXYTYPE]->CreateCollisionAlgorithm(info, a,
                                                                                                               b);
}

btPersistentManifold* Dispatcher::getNewManifold(const btCollisionObject* a, const btCollisionObject* b) {
  btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
  manifold->m_companionIdA = a == lastA_ ? lastPartA_ : lastPartB_;
  manifold->m_companionIdB = a == lastA_ ? lastPartB_ : lastPartA_;
  return manifold;
}

}  // namespace pongsim::physics
