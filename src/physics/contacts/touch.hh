#pragma once

#include <cstdint>
#include <tuple>

class btPersistentManifold;

namespace pongsim::physics {

/// The number of a body that forces do not move. Those that they move are numbered in the order of their slots.
inline constexpr int kNoMember = -1;

/// Two parts of bodies that touch.
struct Touch {
  /// Slots of the links, the smaller one first, and the parts that touch.
  std::uint64_t links;
  std::uint64_t parts;
  btPersistentManifold* manifold;
  /// Numbers of the bodies.
  int a;
  int b;

  /// By slots, so that the order does not depend on what was found first.
  bool operator<(const Touch& other) const { return std::tie(links, parts) < std::tie(other.links, other.parts); }
};

}  // namespace pongsim::physics
