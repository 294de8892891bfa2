#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

#include "base/arena.hh"
#include "shared/threads/workers.hh"
#include "physics/contacts/touch.hh"
#include "physics/islands/islands.hh"
#include "physics/islands/rest.hh"

namespace pongsim::physics {

/// @return Number of a part of a link, made of the collision's number in the link and the piece's in the collision.
constexpr int partNumber(int collision, int piece) { return collision << 10 | piece; }
/// @return The collision's number in such a part number.
constexpr int collisionOfPart(int part) { return part >> 10; }

/// Finds where pairs of bodies touch, and knows which parts each manifold (the points at which two parts touch) belongs
/// to: its companion ids A and B are the numbers of the two parts in their links, or -1 for a body with several parts
/// as a whole. Collisions whose `<collide_bitmask>`s share no bit do not touch.
///
/// Workers process the pairs in parallel. The result for one pair does not depend on any other: each writes only to its
/// own manifolds, and the arena of algorithms and manifolds, which they share, is locked. Only the order in which
/// manifolds are created depends on the threads. A pair is skipped if neither body has moved and the previous step's
/// detection changed nothing. Pairs whose bounding boxes are apart are skipped too; those whose boxes in the broad
/// phase's trees no longer overlap are removed.
class Dispatcher final : public btCollisionDispatcher {
 public:
  /// @param mostContacts Maximum number of contact points of two collisions, unless one of them sets it; negative: no
  /// limit.
  Dispatcher(btCollisionConfiguration& configuration, base::Arena& arena, shared::Workers& workers, Rest& rest,
             long long mostContacts)
      : btCollisionDispatcher(&configuration),
        arena_(arena),
        workers_(workers),
        rest_(rest),
        mostContacts_(mostContacts),
        scratches_(static_cast<std::size_t>(workers.count())) {}

  /// Finds where a pair touches, unless that is known already. May be called for several pairs at once.
  /// @param worker Number of the calling worker.
  /// @param touches The touching parts of the two bodies are appended to it.
  void findTouches(btBroadphasePair& pair, const btDispatcherInfo& info, std::size_t worker,
                   std::vector<Touch>& touches);
  /// Prefetches the manifolds that `findTouches` will need for a pair of the same worker.
  void prefetchManifolds(const btBroadphasePair& pair, std::size_t worker);
  /// Forgets pairs that are no longer near each other; to be called after their touches have been found.
  void removeParted(btOverlappingPairCache& pairs);

  /// @return Numbers of the two bodies.
  static Islands::Ends numbersOf(const btBroadphasePair& pair);

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
  /// For two parts that can't touch.
  btCollisionAlgorithm* noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                    btPersistentManifold* shared);

  /// Working memory of contact detection, kept for the next pair. Not `thread_local`: accessing that from a library
  /// took 7 % of a step of falling shapes.
  struct alignas(64) Scratch {
    btManifoldArray manifolds;
    std::vector<btManifoldPoint> before;
    std::vector<Touch> touches;
  };

  void findUnknownTouches(btBroadphasePair& pair, const btDispatcherInfo& info, Scratch& scratch);
  void collide(btBroadphasePair& pair, const btDispatcherInfo& info, bool isStill, Scratch& scratch);
  void separate(btBroadphasePair& pair, Scratch& scratch);
  void collectTouches(const btManifoldArray& manifolds, std::vector<Touch>& touches) const;

  base::Arena& arena_;
  shared::Workers& workers_;
  Rest& rest_;
  const long long mostContacts_;
  /// One for each worker.
  std::vector<Scratch> scratches_;
  /// Whether there are pairs that are no longer near each other.
  std::atomic<bool> haveParted_ = false;
  /// Guards the arena and Bullet's list of manifolds.
  std::mutex arenaMutex_;
};

}  // namespace pongsim::physics
