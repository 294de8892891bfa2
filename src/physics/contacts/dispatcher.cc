#include "physics/contacts/dispatcher.hh"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btPoolAllocator.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "base/prefetch.hh"
#include "description/link.hh"
#include "physics/contacts/broad_phase.hh"
#include "physics/contacts/contact_limits.hh"
#include "physics/contacts/surface.hh"

namespace pongsim::physics {

namespace {

int numberOf(const btCollisionObjectWrapper* wrapper) {
  const btCollisionShape* part = partOf(wrapper);
  return part == nullptr ? -1 : partNumber(part->getUserIndex(), part->getUserIndex2());
}

/// The pair that an algorithm was last created for on this thread. Bullet tells `getNewManifold` only the two bodies,
/// but calls it in the algorithm's constructor, or as the first thing that the algorithm does afterwards.
struct LastPair {
  const btCollisionObject* a = nullptr;
  int partA = -1;
  int partB = -1;
};
thread_local LastPair lastPair;

/// How many pairs a worker takes at a time; fetching them one by one costs too much.
constexpr std::size_t kPairsAtATime = 16;

/// @return Whether the bitmasks of the two collisions share a bit; true if a compound shape as a whole is meant.
bool masksMeet(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) {
  const btCollisionShape* partA = partOf(a);
  const btCollisionShape* partB = partOf(b);
  if (partA == nullptr || partB == nullptr) return true;
  return (surfaceOf(*partA).collideBitmask & surfaceOf(*partB).collideBitmask) != 0;
}

// stored in a field of the pair that is free for us
constexpr int kSettledPair = 1;
constexpr int kPartedPair = 2;

// a body that moves further in one step is rolling [rad], [m]
constexpr double kSmallTurn = 1e-4;
constexpr double kSmallShift = 1e-5;

const btCollisionObject& objectOf(const btBroadphaseProxy& proxy) {
  return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
}

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

/// @return Whether two points agree in everything that contact detection sets and other code reads.
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

bool havePoints(const btBroadphasePair& pair, btManifoldArray& manifolds) {
  listManifolds(pair, manifolds);
  for (int i = 0; i < manifolds.size(); ++i) {
    if (manifolds[i]->getNumContacts() > 0) return true;
  }
  return false;
}

bool rolls(const btRigidBody& body, const btVector3& normal, double dt) {
  return body.getAngularVelocity().length() * dt > kSmallTurn &&
         body.getLinearVelocity().cross(normal).length() * dt > kSmallShift;
}

/// Forgets the points behind a rolling wheel, which would push it forward; the step finds the points on a plane again.
/// A body that does not roll keeps its points, which give it a broader base.
/// @return Whether points of the pair were forgotten.
bool forgetRolled(const btBroadphasePair& pair, double dt, btManifoldArray& manifolds) {
  const btCollisionObject* objects[] = {&objectOf(*pair.m_pProxy0), &objectOf(*pair.m_pProxy1)};
  const auto isPlane = [](const btCollisionObject* object) {
    return object->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
  };
  if (isPlane(objects[1])) std::swap(objects[0], objects[1]);
  if (!isPlane(objects[0])) return false;
  const btRigidBody& body = *btRigidBody::upcast(objects[1]);
  listManifolds(pair, manifolds);
  bool isOneForgotten = false;
  for (int i = 0; i < manifolds.size(); ++i) {
    btPersistentManifold& manifold = *manifolds[i];
    if (manifold.getNumContacts() == 0 || !rolls(body, manifold.getContactPoint(0).m_normalWorldOnB, dt)) continue;
    manifold.clearManifold();
    isOneForgotten = true;
  }
  return isOneForgotten;
}

Touch touchOf(btPersistentManifold& manifold) {
  const btCollisionObject& a = *manifold.getBody0();
  const btCollisionObject& b = *manifold.getBody1();
  auto slotA = static_cast<std::uint32_t>(a.getUserIndex());
  auto slotB = static_cast<std::uint32_t>(b.getUserIndex());
  auto partA = static_cast<std::uint32_t>(manifold.m_companionIdA);
  auto partB = static_cast<std::uint32_t>(manifold.m_companionIdB);
  if (slotB < slotA) {
    std::swap(slotA, slotB);
    std::swap(partA, partB);
  }
  return {std::uint64_t{slotA} << 32U | slotB, std::uint64_t{partA} << 32U | partB, &manifold, a.getIslandTag(),
          b.getIslandTag()};
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

// as Bullet's own, but in the arena
btPersistentManifold* Dispatcher::getNewManifold(const btCollisionObject* a, const btCollisionObject* b) {
  const btScalar breaking = std::min(a->getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold),
                                     b->getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold));
  const btScalar processing = std::min(a->getContactProcessingThreshold(), b->getContactProcessingThreshold());
  btPersistentManifold* manifold = nullptr;
  {
    const std::lock_guard lock(arenaMutex_);
    void* const place = arena_.allocate(sizeof(btPersistentManifold));
    manifold = ::new (place) btPersistentManifold(a, b, 0, breaking, processing);
    manifold->m_index1a = m_manifoldsPtr.size();
    m_manifoldsPtr.push_back(manifold);
  }
  manifold->m_companionIdA = a == lastPair.a ? lastPair.partA : lastPair.partB;
  manifold->m_companionIdB = a == lastPair.a ? lastPair.partB : lastPair.partA;
  return manifold;
}

void Dispatcher::releaseManifold(btPersistentManifold* manifold) {
  const std::lock_guard lock(arenaMutex_);
  clearManifold(manifold);
  const int index = manifold->m_index1a;
  m_manifoldsPtr.swap(index, m_manifoldsPtr.size() - 1);
  m_manifoldsPtr[index]->m_index1a = index;
  m_manifoldsPtr.pop_back();
  manifold->~btPersistentManifold();
  arena_.free(manifold, sizeof(btPersistentManifold));
}

// all have the size of the largest, because `freeCollisionAlgorithm` is not told the size
std::size_t Dispatcher::algorithmSize() const {
  return static_cast<std::size_t>(m_collisionAlgorithmPoolAllocator->getElementSize());
}

void* Dispatcher::allocateCollisionAlgorithm(int size) {
  assert(static_cast<std::size_t>(size) <= algorithmSize());
  static_cast<void>(size);
  const std::lock_guard lock(arenaMutex_);
  return arena_.allocate(algorithmSize());
}

void Dispatcher::freeCollisionAlgorithm(void* algorithm) {
  const std::lock_guard lock(arenaMutex_);
  arena_.free(algorithm, algorithmSize());
}

Islands::Ends Dispatcher::numbersOf(const btBroadphasePair& pair) {
  return {objectOf(*pair.m_pProxy0).getIslandTag(), objectOf(*pair.m_pProxy1).getIslandTag()};
}

void Dispatcher::prefetchManifolds(const btBroadphasePair& pair, std::size_t worker) {
  btManifoldArray& manifolds = scratches_[worker].manifolds;
  listManifolds(pair, manifolds);
  for (int i = 0; i < manifolds.size(); ++i) {
    // most have one point; the number of points stands behind all of them
    base::prefetch(manifolds[i]->getContactPoint(0));
    base::prefetch(manifolds[i]->m_companionIdA);
  }
}

void Dispatcher::findTouches(btBroadphasePair& pair, const btDispatcherInfo& info, std::size_t worker,
                             std::vector<Touch>& touches) {
  Scratch& scratch = scratches_[worker];
  findUnknownTouches(pair, info, scratch);
  if (pair.m_algorithm == nullptr) return;
  listManifolds(pair, scratch.manifolds);
  collectTouches(scratch.manifolds, touches);
}

void Dispatcher::findUnknownTouches(btBroadphasePair& pair, const btDispatcherInfo& info, Scratch& scratch) {
  bool isStill = pair.m_algorithm != nullptr && rest_.isStill(objectOf(*pair.m_pProxy0)) &&
                 rest_.isStill(objectOf(*pair.m_pProxy1));
  if (pair.m_algorithm != nullptr && forgetRolled(pair, info.m_timeStep, scratch.manifolds)) isStill = false;
  if (isStill && pair.m_internalTmpValue == kSettledPair) return;
  if (BroadPhase::aabbsOverlap(*pair.m_pProxy0, *pair.m_pProxy1)) {
    collide(pair, info, isStill, scratch);
  } else {
    separate(pair, scratch);
  }
}

void Dispatcher::collide(btBroadphasePair& pair, const btDispatcherInfo& info, bool isStill, Scratch& scratch) {
  btManifoldArray& manifolds = scratch.manifolds;
  std::vector<btManifoldPoint>& before = scratch.before;
  before.clear();
  if (isStill) copyPoints(pair, manifolds, before);
  const bool hadPoints = havePoints(pair, manifolds);
  getNearCallback()(pair, *this, info);
  const bool isSettled = isStill && arePoints(pair, manifolds, before);
  pair.m_internalTmpValue = isSettled ? kSettledPair : 0;
  if (isSettled || (!hadPoints && !havePoints(pair, manifolds))) return;
  rest_.disturb(objectOf(*pair.m_pProxy0));
  rest_.disturb(objectOf(*pair.m_pProxy1));
}

void Dispatcher::separate(btBroadphasePair& pair, Scratch& scratch) {
  if (havePoints(pair, scratch.manifolds)) {
    for (int i = 0; i < scratch.manifolds.size(); ++i) scratch.manifolds[i]->clearManifold();
    rest_.disturb(objectOf(*pair.m_pProxy0));
    rest_.disturb(objectOf(*pair.m_pProxy1));
  }
  pair.m_internalTmpValue = 0;
  if (BroadPhase::fatAabbsOverlap(*pair.m_pProxy0, *pair.m_pProxy1)) return;
  pair.m_internalTmpValue = kPartedPair;
  haveParted_.store(true, std::memory_order_relaxed);
}

void Dispatcher::collectTouches(const btManifoldArray& manifolds, std::vector<Touch>& touches) const {
  for (int i = 0; i < manifolds.size(); ++i) {
    btPersistentManifold& manifold = *manifolds[i];
    limitContacts(manifold, mostContacts_);
    if (manifold.getNumContacts() == 0) continue;
    const Touch touch = touchOf(manifold);
    if (touch.a != kNoMember || touch.b != kNoMember) touches.push_back(touch);
  }
}

// backwards, because the last pair takes the place of a removed one
void Dispatcher::removeParted(btOverlappingPairCache& pairs) {
  if (!haveParted_.exchange(false)) return;
  for (int i = pairs.getNumOverlappingPairs() - 1; i >= 0; --i) {
    const btBroadphasePair& pair = pairs.getOverlappingPairArrayPtr()[i];
    if (pair.m_internalTmpValue == kPartedPair) pairs.removeOverlappingPair(pair.m_pProxy0, pair.m_pProxy1, this);
  }
}

void Dispatcher::dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                           btDispatcher* /*dispatcher*/) {
  const auto count = static_cast<std::size_t>(pairs->getNumOverlappingPairs());
  btBroadphasePair* const first = pairs->getOverlappingPairArrayPtr();
  workers_.forEach((count + kPairsAtATime - 1) / kPairsAtATime, [&](std::size_t chunk, int worker) {
    const auto number = static_cast<std::size_t>(worker);
    scratches_[number].touches.clear();
    const std::size_t end = std::min(count, (chunk + 1) * kPairsAtATime);
    for (std::size_t i = chunk * kPairsAtATime; i < end; ++i) {
      findTouches(first[i], info, number, scratches_[number].touches);
    }
  });
  removeParted(*pairs);
}

}  // namespace pongsim::physics
