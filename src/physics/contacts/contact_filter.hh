#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::physics {

/// Which links may touch: not two that stand still, not two that a joint connects, and two of one model only if model
/// and links ask for it (`<self_collide>`). Finds a link's slot in its collision object's user index.
class ContactFilter final : public btOverlapFilterCallback {
 public:
  explicit ContactFilter(const world::Entities& entities);

  /// To be called when joints or links have come or gone.
  void update();
  /// As `update`, where they have come only.
  void grow();

  bool mayTouch(world::Slot a, world::Slot b) const;
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

 private:
  const world::Entities& entities_;
  /// Pairs of slots that a joint connects, smaller slot first, sorted.
  std::vector<std::pair<world::Slot, world::Slot>> jointed_;
  /// How many joints have been looked at.
  std::size_t known_ = 0;
};

}  // namespace pongsim::physics
