#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <cstddef>
#include <span>
#include <vector>

namespace pongsim::physics {

/// Keeps Bullet's trees of bounding boxes shallow. Bullet puts a box beside the nearest one, so that a tree of n boxes
/// in a row is n nodes deep, and inserting them takes time quadratic in n.
///
/// As in a scapegoat tree (Galperin and Rivest, "Scapegoat Trees", 1993), nodes store nothing for this: a part of the
/// tree is rebuilt when a leaf gets too deep. The depth stays below 2.5 log2(n) + 3.5, and an insertion takes O(log^2
/// n) on average over all insertions.
class TreeBalance {
 public:
  /// Call it after the leaf was inserted into the tree or moved in it.
  void keepShallow(btDbvt& tree, btDbvtNode& leaf) noexcept;

 private:
  void balance(btDbvt& tree, btDbvtNode& leaf);
  std::size_t countLeaves(btDbvtNode& root);
  void rebuild(btDbvt& tree, btDbvtNode& root);
  /// Adds the nodes below a node, itself included, to `leaves_` and `inner_`.
  void collect(btDbvtNode& root);
  btDbvtNode* build(std::span<btDbvtNode*> leaves, btDbvtNode* parent);

  // kept, so that a step needs no memory
  std::vector<btDbvtNode*> open_;
  std::vector<btDbvtNode*> leaves_;
  std::vector<btDbvtNode*> inner_;
};

}  // namespace pongsim::physics
