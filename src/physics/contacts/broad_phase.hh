#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <utility>

#include "base/prefetch.hh"

namespace pongsim::physics {

/// Which bodies are near each other, by Bullet's trees of boxes: one for what forces move, one for the rest. A body has
/// room in its box there, so that most steps change nothing in the trees and most bodies need only be looked at, on
/// several threads at once.
///
/// A pair is there while the two have boxes in the trees that meet. Who looks at the pairs takes out the others.
class BroadPhase final : public btDbvtBroadphase {
 public:
  btBroadphaseProxy* createProxy(const btVector3& lowest, const btVector3& highest, int shape, void* object, int group,
                                 int mask, btDispatcher* dispatcher) override;
  /// For a body that is somewhere else at once.
  void setAabb(btBroadphaseProxy* proxy, const btVector3& lowest, const btVector3& highest,
               btDispatcher* dispatcher) override;
  /// There is nothing left to do in a step: pairs are found as boxes leave those of the tree.
  void calculateOverlappingPairs(btDispatcher* dispatcher) override;

  /// Says what holds a body now and at the end of the step. May be called for several at once.
  /// @return Whether its box in the tree holds that; else `leave` is to be called.
  static bool stay(btBroadphaseProxy& proxy, const btVector3& lowest, const btVector3& highest);
  /// Gives the body a new box in the tree, with room on the way that it goes.
  /// @param way Where it gets in some steps [m].
  void leave(btBroadphaseProxy& proxy, const btVector3& way);
  /// Finds the pairs of a body anew, for those that the filter refused before.
  void findPairs(btBroadphaseProxy& proxy);
  /// @return Whether pairs have come since this was asked last.
  bool takeNewPairs() { return std::exchange(haveNewPairs_, false); }

  /// Asks for the memory of a body's place here, and then, once that is there, of its box in the tree.
  static void prefetch(const btBroadphaseProxy& proxy) { base::prefetch(static_cast<const btDbvtProxy&>(proxy)); }
  static void prefetchLeaf(const btBroadphaseProxy& proxy) {
    base::prefetch(static_cast<const btDbvtProxy&>(proxy).leaf->volume);
  }

  /// @return Whether what holds the two now meets.
  static bool meet(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    return TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax);
  }
  /// @return Whether they have boxes in the trees that meet.
  static bool areNear(const btBroadphaseProxy& a, const btBroadphaseProxy& b);

 private:
  void put(btDbvtProxy& proxy, btDbvtVolume volume);

  bool haveNewPairs_ = false;
};

}  // namespace pongsim::physics
