#include "physics/dispatcher.hh"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cstddef>

#include "description/link.hh"
#include "physics/surface.hh"

namespace pongsim::physics {

namespace {

int numberOf(const btCollisionObjectWrapper* wrapper) {
  const btCollisionShape* part = partOf(wrapper);
  return part == nullptr ? -1 : partNumber(part->getUserIndex(), part->getUserIndex2());
}

/// Of what an algorithm was made last on this thread. It makes its manifold when it is made itself, or as the first
/// thing that it does then.
struct LastPair {
  const btCollisionObject* a = nullptr;
  int partA = -1;
  int partB = -1;
};
thread_local LastPair lastPair;

/// How many pairs a worker takes at a time: one is too little to be worth the asking.
constexpr std::size_t kPairsAtATime = 8;

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
  lastPair = {a->getCollisionObject(), numberOf(a), numberOf(b)};
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
  btPersistentManifold* manifold = nullptr;
  {
    const std::lock_guard lock(pools_);
    manifold = btCollisionDispatcher::getNewManifold(a, b);
  }
  manifold->m_companionIdA = a == lastPair.a ? lastPair.partA : lastPair.partB;
  manifold->m_companionIdB = a == lastPair.a ? lastPair.partB : lastPair.partA;
  return manifold;
}

void Dispatcher::releaseManifold(btPersistentManifold* manifold) {
  const std::lock_guard lock(pools_);
  btCollisionDispatcher::releaseManifold(manifold);
}

void* Dispatcher::allocateCollisionAlgorithm(int size) {
  const std::lock_guard lock(pools_);
  return btCollisionDispatcher::allocateCollisionAlgorithm(size);
}

void Dispatcher::freeCollisionAlgorithm(void* algorithm) {
  const std::lock_guard lock(pools_);
  btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
}

void Dispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                           btDispatcher* /*dispatcher*/) {
  const auto count = static_cast<std::size_t>(pairs->getNumOverlappingPairs());
  btBroadphasePair* const first = pairs->getOverlappingPairArrayPtr();
  workers_.forEach((count + kPairsAtATime - 1) / kPairsAtATime, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(count, (chunk + 1) * kPairsAtATime);
    for (std::size_t i = chunk * kPairsAtATime; i < end; ++i) getNearCallback()(first[i], *this, info);
  });
}

}  // namespace pongsim::physics
