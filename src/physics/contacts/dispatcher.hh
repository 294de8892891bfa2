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

/// @return Number of a part of a link, made of the collision's number in the link and the piece's in the collision.
constexpr int partNumber(int collision, int piece) { return collision << 10 | piece; }
/// @return The collision's number in such a part number.
constexpr int collisionOfPart(int part) { return part >> 10; }

/// Finds where pairs of bodies touch, and knows which parts each manifold (the points at which two parts touch) belongs
/// to: its companion ids A and B are the numbers of the two parts in their links, or -1 for a body with several parts
/// as a whole. Collisions whose `<collide_bitmask>`s share no bit do not touch.
///
/// Workers process the pairs in parallel. The result for one pair does not depend on any other: each writes only to its
/// own manifolds, and the shared pools of algorithms and manifolds are locked. Only the order in which manifolds are
/// created depends on the threads. A pair is skipped if neither body has moved and the previous step's detection
/// changed nothing. Pairs whose bounding boxes are apart are skipped too; those whose boxes in the broad phase's trees
/// no longer overlap are removed.
class Dispatcher final : public btCollisionDispatcher {
 public:
  /// @param mostContacts Maximum number of contact points of two collisions, unless one of them sets it; negative: no
  /// limit.
  Dispatcher(btCollisionConfiguration& configuration, base::Workers& workers, Rest& rest, long long mostContacts)
      : btCollisionDispatcher(&configuration),
        workers_(workers),
        rest_(rest),
        mostContacts_(mostContacts),
        touches_(static_cast<std::size_t>(workers.count())),
        looks_(touches_.size()) {}

  /// @return The last known contacts in which at least one body is moved by forces.
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
  /// For two parts that can't touch.
  btCollisionAlgorithm* noAlgorithm(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                                    btPersistentManifold* shared);

  /// Working memory of contact detection, kept for the next pair. Not `thread_local`: accessing that from a library
  /// took 7 % of a step of falling shapes.
  struct alignas(64) Look {
    btManifoldArray manifolds;
    std::vector<btManifoldPoint> before;
  };

  void prefetchPairs(const btBroadphasePair* pairs, std::size_t now, std::size_t count,
                     btManifoldArray& manifolds) const;
  /// Finds where a pair touches, unless that is known already.
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
  /// Whether there are pairs that are no longer near each other.
  std::atomic<bool> haveParted_ = false;
  /// Guards Bullet's pools and its list of manifolds.
  std::mutex pools_;
};

}  // namespace pongsim::physics
