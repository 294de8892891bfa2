#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <utility>

#include "base/prefetch.hh"
#include "physics/contacts/tree_balance.hh"

namespace pongsim::physics {

/// Finds which bodies are near each other, with Bullet's trees of bounding boxes: one tree for bodies moved by forces,
/// one for the rest. Boxes in the trees have a margin, so most steps leave the trees unchanged and most bodies only
/// need a check, which several threads can do at once.
///
/// A pair exists while the two boxes in the trees overlap. The caller that goes through the pairs removes the others.
class BroadPhase final : public btDbvtBroadphase {
 public:
  btBroadphaseProxy* createProxy(const btVector3& lowest, const btVector3& highest, int shape, void* object, int group,
                                 int mask, btDispatcher* dispatcher) override;
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
  /// Does nothing: pairs are found when a box leaves its box in the tree.
  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

  /// Sets the bounding box of a body's motion in this step. Can be called for several bodies at once.
  /// @return Whether the body's box in the tree contains it; if not, call `leave`.
  static bool stay(btBroadphaseProxy& proxy, const btVector3& lowest, const btVector3& highest);
  /// Gives the body a new box in the tree, with a margin in the direction of motion.
  /// @param way Expected displacement over the next few steps [m].
  void leave(btBroadphaseProxy& proxy, const btVector3& way);
  /// Finds the pairs of a body again, including those that the filter rejected before.
  void findPairs(btBroadphaseProxy& proxy);
  /// @return Whether pairs have come since this was asked last.
  bool takeNewPairs() { return std::exchange(haveNewPairs_, false); }

  /// Prefetches a body's proxy and, once that has arrived, its box in the tree.
  static void prefetch(const btBroadphaseProxy& proxy) { base::prefetch(static_cast<const btDbvtProxy&>(proxy)); }
  static void prefetchLeaf(const btBroadphaseProxy& proxy) {
    base::prefetch(static_cast<const btDbvtProxy&>(proxy).leaf->volume);
  }

  /// @return Whether the current bounding boxes overlap.
  static bool meet(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
  }
  /// @return Whether their boxes in the trees overlap.
  static bool areNear(const btBroadphaseProxy& a, const btBroadphaseProxy& b);

 private:
  btDbvt& treeOf(const btDbvtProxy& proxy);
  void put(btDbvtProxy& proxy, btDbvtVolume volume);

  TreeBalance balance_;
  bool haveNewPairs_ = false;
};

}  // namespace pongsim::physics
