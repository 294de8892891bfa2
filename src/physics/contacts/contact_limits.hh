#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/contacts/touch.hh"

namespace pongsim::physics {

/// Removes the shallowest points of a manifold beyond the maximum of its two collisions.
/// @param most The maximum if neither sets one; negative: no limit.
void limitContacts(btPersistentManifold& manifold, long long most);

/// Likewise for all manifolds that two collisions have together, because they may touch with many pieces. Keeps its
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
