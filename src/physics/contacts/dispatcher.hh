#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <atomic>
#include <mutex>
#include <span>
#include <vector>

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
/// to its own manifolds only, and what they share, the pools that algorithms and manifolds come from, is locked. The
/// order in which manifolds are made then depends on the threads; nothing else does. Where neither body has moved, and
/// looking has changed nothing in the step before, it is not looked again. Two that are apart, with room between what
/// holds them, are not looked at; those that have gone from the broad phase's trees are forgotten.
class Dispatcher final : public btCollisionDispatcher {
 public:
  /// @param mostContacts At how many points two collisions may touch, where neither says how many; negative: no limit.
  Dispatcher(btCollisionConfiguration& configuration, base::Workers& workers, Rest& rest, long long mostContacts)
      : btCollisionDispatcher(&configuration),
        workers_(workers),
        rest_(rest),
        mostContacts_(mostContacts),
        touches_(static_cast<std::size_t>(workers.count())),
        looks_(touches_.size()) {}

  /// @return What touches, of which at least one is moved by forces, as it was found last.
  std::span<const FoundTouches> touches() const { return touches_; }

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

  /// What looking at a pair takes, kept for the next one. Not the thread's own (`thread_local`): to find that in a
  /// library was 7 % of a step of shapes that fall.
  struct alignas(64) Look {
    btManifoldArray manifolds;
    std::vector<btManifoldPoint> before;
  };

  void prefetchPairs(const btBroadphasePair* pairs, std::size_t now, std::size_t count,
                     btManifoldArray& manifolds) const;
  /// Finds where a pair touches, where that is not known.
  void findTouches(btBroadphasePair& pair, const btDispatcherInfo& info, Look& memory);
  void look(btBroadphasePair& pair, const btDispatcherInfo& info, bool isStill, Look& memory);
  void part(btBroadphasePair& pair, Look& memory);
  void collectTouches(const btManifoldArray& manifolds, std::vector<Touch>& touches) const;
  void removeParted(btOverlappingPairCache& pairs);

  base::Workers& workers_;
  Rest& rest_;
  const long long mostContacts_;
  /// One for each worker.
  std::vector<FoundTouches> touches_;
  std::vector<Look> looks_;
  /// Whether there are pairs that are no longer near.
  std::atomic<bool> haveParted_ = false;
  /// Of Bullet's pools and list of manifolds.
  std::mutex pools_;
};

}  // namespace pongsim::physics
