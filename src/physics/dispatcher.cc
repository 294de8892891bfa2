#include "physics/dispatcher.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "physics/surface.hh"

namespace pongsim::physics {

namespace {

int partNumber(const btCollisionObjectWrapper* wrapper) {
  const btCollisionShape* part = partOf(wrapper);
  return part == nullptr ? -1 : part->getUserIndex();
}

}  // namespace

btCollisionAlgorithm* Dispatcher::findAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                                btPersistentManifold* shared, ebtDispatcherQueryType type) {
  lastA_ = a->getCollisionObject();
  lastPartA_ = partNumber(a);
  lastPartB_ = partNumber(b);
  return btCollisionDispatcher::findAlgorithm(a, b, shared, type);
}

btPersistentManifold* Dispatcher::getNewManifold(const btCollisionObject* a, const btCollisionObject* b) {
  btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
  manifold->m_companionIdA = a == lastA_ ? lastPartA_ : lastPartB_;
  manifold->m_companionIdB = a == lastA_ ? lastPartB_ : lastPartA_;
  return manifold;
}

}  // namespace pongsim::physics
