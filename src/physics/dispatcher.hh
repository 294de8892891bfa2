#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <mutex>

#include "base/workers.hh"
#include "physics/rest.hh"

namespace pongsim::physics {

/// @return Number of a part of a link: of the collision in the link and of the piece in the collision.
constexpr int partNumber(int collision, int piece) { return collision << 10 | piece; }
/// @return Of such a number, the collision's.
constexpr int collisionOfPart(int part) { return part >> 10; }

/// Finds where pairs of bodies touch, and knows of each manifold (the points at which two parts touch) whose it is: the
/// numbers of the two parts in their links are its companion ids A and B, -1 where a body is made of several parts and
/// all of it is meant. Collisions whose `<collide_bitmask>` share no bit do not touch.
///
/// Pairs are shared out among workers. What is found for one depends on nothing that is found for another: each writes
/// to its own manifolds only, and what they share, the pools that algorithms and manifolds come from, is locked. The
/// order in which manifolds are made then depends on the threads; nothing else does. Where neither body has moved, and
/// looking has changed nothing in the step before, it is not looked again.
class Dispatcher final : public btCollisionDispatcher {
 public:
  Dispatcher(btCollisionConfiguration& configuration, base::Workers& workers, Rest& rest)
      : btCollisionDispatcher(&configuration), workers_(workers), rest_(rest) {}

  btCollisionAlgorithm* findAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                      btPersistentManifold* shared, ebtDispatcherQueryType type) override;
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override;
  void releaseManifold(btPersistentManifold* manifold) override;
  void* allocateCollisionAlgorithm(int size) override;
  void freeCollisionAlgorithm(void* algorithm) override;
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

 private:
  /// For two parts that do not touch.
  btCollisionAlgorithm* noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                    btPersistentManifold* shared);

  /// Finds where a pair touches, where that is not known.
  void findTouches(btBroadphasePair& pair, const btDispatcherInfo& info);

  base::Workers& workers_;
  Rest& rest_;
  /// Of Bullet's pools and list of manifolds.
  std::mutex pools_;
};

}  // namespace pongsim::physics
