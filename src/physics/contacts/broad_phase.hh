#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "physics/contacts/tree_balance.hh"

namespace pongsim::physics {

/// Finds which bodies are near each other, with Bullet's trees of bounding boxes: one tree for bodies moved by forces,
/// one for the rest. The boxes in the trees are fat: they have a margin, so most steps leave the trees unchanged and
/// most bodies only need a check, which several threads can do at once.
///
/// A pair exists while two fat boxes overlap. The caller that goes through the pairs removes the others.
///
/// Bodies inside one another have a number of pairs that is quadratic in theirs, at 5 KB each with contacts. So beyond
/// a number that is linear in that of moving bodies, pairs are refused.
class BroadPhase final : public btDbvtBroadphase {
 public:
  /// Adds an object, and finds its pairs.
  /// @param forcesMove Which of the trees it goes to.
  /// @param number Unique; in a pair, the object with the smaller number comes first.
  btBroadphaseProxy& add(const btVector3& lowest, const btVector3& highest, btCollisionObject* object, bool forcesMove,
                         int number);
  /// For a body whose pairs have been removed.
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;
  /// Removes all pairs of the bodies for which `goes(proxy)` is true, with their contacts, in one pass.
  template <class Goes>
  void removePairs(const Goes& goes, btDispatcher& dispatcher) {
    // backwards, because the last pair takes the place of a removed one
    for (int i = m_paircache->getNumOverlappingPairs() - 1; i >= 0; --i) {
      const btBroadphasePair& pair = m_paircache->getOverlappingPairArrayPtr()[i];
      if (!goes(*pair.m_pProxy0) && !goes(*pair.m_pProxy1)) continue;
      m_paircache->removeOverlappingPair(pair.m_pProxy0, pair.m_pProxy1, &dispatcher);
    }
  }
  /// For a body that jumps to another place.
  void setAabb(btBroadphaseProxy* proxy, const btVector3& lowest, const btVector3& highest,
               btDispatcher* dispatcher) override;
  /// Improves the tree of moving bodies a little. (Pairs are found when a body leaves its fat box.)
  void optimize() { m_sets[DYNAMIC_SET].optimizeIncremental(1); }

  /// Sets the bounding box of a body's motion in this step. Can be called for several bodies at once.
  /// @return Whether the body's fat box contains it; if not, call `fattenAabb`.
  static bool updateAabb(btBroadphaseProxy& proxy, const btVector3& lowest, const btVector3& highest);
  /// Gives the body a new fat box, with a margin on all sides and further in the direction of motion.
  /// @param motion Expected displacement over the next few steps [m].
  void fattenAabb(btBroadphaseProxy& proxy, const btVector3& motion);
  /// Finds the pairs of a body again, including those that the filter rejected before.
  void findPairs(btBroadphaseProxy& proxy);
  /// @return Whether pairs have come since this was asked last.
  bool takeNewPairs() { return std::exchange(haveNewPairs_, false); }

  /// @return How many pairs of moving bodies there may be; with others, there may be twice as many.
  std::size_t mostPairs() const;
  /// @return About how many pairs were refused.
  std::size_t refusedPairs() const { return std::max(refused_, (refusedAgain_ + 1) / 2); }
  /// Finds the pairs of these bodies again if some were refused and there is room now.
  void findRefusedPairs(std::span<btRigidBody* const> bodies);

  /// @return Whether the current bounding boxes overlap.
  static bool aabbsOverlap(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
  }
  /// @return Whether their fat boxes overlap.
  static bool fatAabbsOverlap(const btBroadphaseProxy& a, const btBroadphaseProxy& b);

 private:
  btDbvt& treeOf(const btDbvtProxy& proxy);
  void put(btDbvtProxy& proxy, btDbvtVolume volume);
  /// @return How many were refused.
  std::size_t findPairsNow(btBroadphaseProxy& proxy);

  TreeBalance balance_;
  bool haveNewPairs_ = false;
  /// When bodies were added, each pair once; and later, mostly once for each of the two bodies.
  std::size_t refused_ = 0;
  std::size_t refusedAgain_ = 0;
  bool isOneMissing_ = false;
};

}  // namespace pongsim::physics
