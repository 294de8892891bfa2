#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/contacts/touch.hh"

namespace pongsim::physics {

/// Leaves the deepest points of a manifold, as many as its two collisions may touch at.
/// @param most Where neither says how many; negative: no limit.
void limitContacts(btPersistentManifold& manifold, long long most);

/// Likewise of all manifolds that two collisions have together, for they may touch with many of their pieces. Keeps its
/// memory.
class PieceLimits {
 public:
  /// @param touches In their order.
  /// @return How many of them still have points; these come first, in their order.
  std::size_t limit(std::span<Touch> touches, long long most);

 private:
  /// A point of contact, and how far it is from those that are kept, squared.
  struct Point {
    btPersistentManifold* manifold;
    int index;
    double distance;
    bool isKept;
  };
  /// Leaves that many points.
  /// @return Whether a manifold has none any more.
  bool keepSpread(std::span<const Touch> touches, std::size_t most);

  /// Of two collisions.
  std::vector<Point> points_;
};

}  // namespace pongsim::physics
