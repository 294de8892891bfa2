#include "physics/dispatcher.hh"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

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

// in a pair's number that is free for use
constexpr int kSettledPair = 1;

void listManifolds(const btBroadphasePair& pair, btManifoldArray& manifolds) {
  manifolds.resizeNoInitialize(0);
  if (pair.m_algorithm != nullptr) pair.m_algorithm->getAllContactManifolds(manifolds);
}

void copyPoints(const btBroadphasePair& pair, btManifoldArray& manifolds, std::vector<btManifoldPoint>& points) {
  listManifolds(pair, manifolds);
  for (int i = 0; i < manifolds.size(); ++i) {
    for (int j = 0; j < manifolds[i]->getNumContacts(); ++j) points.push_back(manifolds[i]->getContactPoint(j));
  }
}

/// @return Whether the two are the same in all that looking for contacts sets and that counts for others.
bool isSamePoint(const btManifoldPoint& a, const btManifoldPoint& b) {
  const auto same = [](const btVector3& one, const btVector3& other) {
    return std::memcmp(&one[0], &other[0], 3 * sizeof(btScalar)) == 0;
  };
  return same(a.m_localPointA, b.m_localPointA) && same(a.m_localPointB, b.m_localPointB) &&
         same(a.m_positionWorldOnA, b.m_positionWorldOnA) && same(a.m_positionWorldOnB, b.m_positionWorldOnB) &&
         same(a.m_normalWorldOnB, b.m_normalWorldOnB) &&
         std::memcmp(&a.m_distance1, &b.m_distance1, sizeof(btScalar)) == 0 && a.m_index0 == b.m_index0 &&
         a.m_index1 == b.m_index1;
}

bool arePoints(const btBroadphasePair& pair, btManifoldArray& manifolds, const std::vector<btManifoldPoint>& points) {
  listManifolds(pair, manifolds);
  std::size_t next = 0;
  for (int i = 0; i < manifolds.size(); ++i) {
    for (int j = 0; j < manifolds[i]->getNumContacts(); ++j, ++next) {
      if (next == points.size() || !isSamePoint(points[next], manifolds[i]->getContactPoint(j))) return false;
    }
  }
  return next == points.size();
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

void Dispatcher::findTouches(btBroadphasePair& pair, const btDispatcherInfo& info) {
  const auto& a = *static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
  const auto& b = *static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
  const bool isStill = pair.m_algorithm != nullptr && rest_.isStill(a) && rest_.isStill(b);
  if (isStill && pair.m_internalTmpValue == kSettledPair) return;
  // one of a thread, for a step allocates nothing
  thread_local std::vector<btManifoldPoint> before;
  thread_local btManifoldArray manifolds;
  before.clear();
  if (isStill) copyPoints(pair, manifolds, before);
  getNearCallback()(pair, *this, info);
  const bool isSettled = isStill && arePoints(pair, manifolds, before);
  pair.m_internalTmpValue = isSettled ? kSettledPair : 0;
  if (isSettled) return;
  rest_.disturb(a);
  rest_.disturb(b);
}

void Dispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                           btDispatcher* /*dispatcher*/) {
  const auto count = static_cast<std::size_t>(pairs->getNumOverlappingPairs());
  btBroadphasePair* const first = pairs->getOverlappingPairArrayPtr();
  workers_.forEach((count + kPairsAtATime - 1) / kPairsAtATime, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(count, (chunk + 1) * kPairsAtATime);
    for (std::size_t i = chunk * kPairsAtATime; i < end; ++i) findTouches(first[i], info);
  });
}

}  // namespace pongsim::physics
