#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "base/arena.hh"
#include "base/workers.hh"
#include "physics/contacts/touch.hh"
#include "physics/solving/rest.hh"

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
/// to its own manifolds only, and what they share, the arena that algorithms and manifolds come from, is locked. The
/// order in which manifolds are made then depends on the threads; nothing else does. Where neither body has moved, and
/// looking has changed nothing in the step before, it is not looked again. Two that are apart, with room between what
/// holds them, are not looked at; those that have gone from the broad phase's trees are forgotten.
class Dispatcher final : public btCollisionDispatcher {
 public:
  /// @param mostContacts At how many points two collisions may touch, where neither says how many; negative: no limit.
  Dispatcher(btCollisionConfiguration& configuration, base::Arena& arena, base::Workers& workers, Rest& rest,
             long long mostContacts)
      : btCollisionDispatcher(&configuration),
        arena_(arena),
        workers_(workers),
        rest_(rest),
        mostContacts_(mostContacts),
        looks_(static_cast<std::size_t>(workers.count())) {}

  /// Finds where a pair touches, where that is not known. May be called for several at once.
  /// @param worker Number of who calls.
  /// @param touches To which are added those parts of the two that touch.
  void findTouches(btBroadphasePair& pair, const btDispatcherInfo& info, std::size_t worker,
                   std::vector<Touch>& touches);
  /// Forgets pairs that are no longer near; to be called when their touches have been found.
  void removeParted(btOverlappingPairCache& pairs);

  /// @return Numbers of the two bodies; `kNoMember` for what forces do not move.
  static std::pair<int, int> numbersOf(const btBroadphasePair& pair);

  /// These ask for the memory of what `findTouches` needs, each time what the time before has led to. Nobody must be at
  /// the pair when its algorithm and manifolds are asked for.
  static void prefetchProxies(const btBroadphasePair& pair);
  static void prefetchObjects(const btBroadphasePair& pair);
  void prefetchManifolds(const btBroadphasePair& pair, std::size_t worker);

  btCollisionAlgorithm* findAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                      btPersistentManifold* shared, ebtDispatcherQueryType type) override;
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override;
  void releaseManifold(btPersistentManifold* manifold) override;
  void* allocateCollisionAlgorithm(int size) override;
  void freeCollisionAlgorithm(void* algorithm) override;
  /// Of all pairs, beside a step.
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

 private:
  std::size_t algorithmSize() const;
  /// For two parts that do not touch.
  btCollisionAlgorithm* noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                    btPersistentManifold* shared);

  /// What looking at a pair takes, kept for the next one. Not the thread's own (`thread_local`): to find that in a
  /// library was 7 % of a step of shapes that fall.
  struct alignas(64) Look {
    btManifoldArray manifolds;
    std::vector<btManifoldPoint> before;
    std::vector<Touch> touches;
  };

  void findUnknownTouches(btBroadphasePair& pair, const btDispatcherInfo& info, Look& memory);
  void look(btBroadphasePair& pair, const btDispatcherInfo& info, bool isStill, Look& memory);
  void part(btBroadphasePair& pair, Look& memory);
  void collectTouches(const btManifoldArray& manifolds, std::vector<Touch>& touches) const;

  base::Arena& arena_;
  base::Workers& workers_;
  Rest& rest_;
  const long long mostContacts_;
  /// One for each worker.
  std::vector<Look> looks_;
  /// Whether there are pairs that are no longer near.
  std::atomic<bool> haveParted_ = false;
  /// Of the arena and Bullet's list of manifolds.
  std::mutex arenaMutex_;
};

}  // namespace pongsim::physics
