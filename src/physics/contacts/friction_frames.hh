#pragma once

#include <span>
#include <vector>

#include "base/arena.hh"
#include "physics/body.hh"
#include "world/entities.hh"

namespace pongsim::physics {

/// The collisions whose first friction direction is in the frame of another link of their model.
class FrictionFrames {
 public:
  /// Looks for them in the bodies from `first` on.
  /// @param bodies One a link, in the order of their slots.
  void find(std::span<const base::Arena::Pointer<Body>> bodies, world::Slot first, const world::Entities& entities);

  /// Forgets those of links that are removed but still have their slots.
  /// @param links Their slots, in ascending order.
  void remove(const std::vector<world::Slot>& links);

  /// Likewise those of links from this slot on.
  void removeFrom(world::Slot first) {
    std::erase_if(frames_, [first](const Frame& each) { return each.body->link() >= first; });
  }

  void clear() { frames_.clear(); }
  bool empty() const { return frames_.empty(); }

  /// Rotates the directions with their frames. To be called on one thread before bodies move, because the other link
  /// may be in another island.
  void turn();

 private:
  struct Frame {
    LinkShape::Part* part;
    const Body* body;
    /// The other link's.
    const Body* frame;
  };
  std::vector<Frame> frames_;
};

}  // namespace pongsim::physics
