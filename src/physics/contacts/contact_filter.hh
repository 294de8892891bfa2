#pragma once

#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::physics {

/// Decides which links may collide: not two that don't move, not two connected by a joint, and two of the same skeleton
/// only if its model asks for it (`<self_collide>`; that of a link has no effect, as in Fortress). As in Fortress's
/// DART, a link belongs to the skeleton of its model, unless joints of the file hang it on a link of another model,
/// such as the one in which its own is nested. Reads a link's slot from its collision object's user index.
class ContactFilter final : public btOverlapFilterCallback {
 public:
  explicit ContactFilter(const world::Entities& entities);

  /// Call after joints or links have been removed. Does not allocate.
  /// @param links So many of them count, from the first on.
  /// @param joints Likewise.
  void update(std::size_t links, std::size_t joints);
  /// Like `update`, for when they have only been added.
  void grow(std::size_t links, std::size_t joints);

  bool mayTouch(world::Slot a, world::Slot b) const;
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

 private:
  void findSkeletons(std::size_t links, std::size_t joints);

  const world::Entities& entities_;
  /// Pairs of slots connected by a joint, smaller slot first, sorted.
  std::vector<std::pair<world::Slot, world::Slot>> jointed_;
  /// For each link, the model to whose skeleton it belongs.
  std::vector<world::Slot> skeletons_;
  /// For each link, the one that its joint hangs it on, for `findSkeletons`.
  std::vector<world::Slot> parents_;
  /// Number of joints read so far.
  std::size_t known_ = 0;
};

}  // namespace pongsim::physics
