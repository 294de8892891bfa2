#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::physics {

/// Decides which links may collide: not two that don't move, not two connected by a joint, and two of the same model
/// only if the model and links ask for it (`<self_collide>`). Reads a link's slot from its collision object's user
/// index.
class ContactFilter final : public btOverlapFilterCallback {
 public:
  explicit ContactFilter(const world::Entities& entities);

  /// Call after joints or links have been removed. Does not allocate.
  /// @param joints So many of them count, from the first on.
  void update(std::size_t joints);
  /// Like `update`, for when they have only been added.
  void grow(std::size_t joints);

  bool mayTouch(world::Slot a, world::Slot b) const;
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

 private:
  const world::Entities& entities_;
  /// Pairs of slots connected by a joint, smaller slot first, sorted.
  std::vector<std::pair<world::Slot, world::Slot>> jointed_;
  /// Number of joints read so far.
  std::size_t known_ = 0;
};

}  // namespace pongsim::physics
