#include "physics/contacts/tree_balance.hh"

#include <algorithm>
#include <bit>
#include <new>

namespace pongsim::physics {

namespace {

std::size_t depthOf(const btDbvtNode& leaf) {
  std::size_t depth = 0;
  for (const btDbvtNode* node = leaf.parent; node != nullptr; node = node->parent) ++depth;
  return depth;
}

/// A leaf below this depth has an ancestor one child of which has more than three quarters of its leaves, since
/// log(n) / log(4/3) < 2.5 log2(n).
std::size_t largestDepth(std::size_t leaves) { return 5 * static_cast<std::size_t>(std::bit_width(leaves)) / 2 + 1; }

bool isTooLarge(std::size_t child, std::size_t whole) { return 4 * child > 3 * whole; }

btDbvtNode& siblingOf(const btDbvtNode& node) { return *node.parent->childs[node.parent->childs[0] == &node ? 1 : 0]; }

/// @return The axis along which the centres of the boxes are farthest apart.
int longestAxis(std::span<btDbvtNode* const> leaves) {
  btVector3 lowest = leaves.front()->volume.Center(), highest = lowest;
  for (const btDbvtNode* leaf : leaves) {
    lowest.setMin(leaf->volume.Center());
    highest.setMax(leaf->volume.Center());
  }
  return (highest - lowest).maxAxis();
}

}  // namespace

void TreeBalance::keepShallow(btDbvt& tree, btDbvtNode& leaf) noexcept {
  try {
    balance(tree, leaf);
  } catch (const std::bad_alloc&) {
    // nothing is changed before all memory is there, and a deep tree finds the same pairs
  }
}

void TreeBalance::balance(btDbvt& tree, btDbvtNode& leaf) {
  if (depthOf(leaf) <= largestDepth(static_cast<std::size_t>(tree.m_leaves))) return;
  std::size_t leaves = 1;
  for (btDbvtNode* node = &leaf; node->parent != nullptr; node = node->parent) {
    const std::size_t whole = leaves + countLeaves(siblingOf(*node));
    if (isTooLarge(leaves, whole)) return rebuild(tree, *node->parent);
    leaves = whole;
  }
}

std::size_t TreeBalance::countLeaves(btDbvtNode& root) {
  std::size_t count = 0;
  open_.assign(1, &root);
  while (!open_.empty()) {
    const btDbvtNode& node = *open_.back();
    open_.pop_back();
    if (node.isleaf()) {
      ++count;
    } else {
      open_.insert(open_.end(), {node.childs[0], node.childs[1]});
    }
  }
  return count;
}

void TreeBalance::collect(btDbvtNode& root) {
  leaves_.clear();
  inner_.clear();
  open_.assign(1, &root);
  while (!open_.empty()) {
    btDbvtNode* const node = open_.back();
    open_.pop_back();
    if (node->isleaf()) {
      leaves_.push_back(node);
    } else {
      inner_.push_back(node);
      open_.insert(open_.end(), {node->childs[0], node->childs[1]});
    }
  }
}

void TreeBalance::rebuild(btDbvt& tree, btDbvtNode& root) {
  btDbvtNode* const parent = root.parent;
  btDbvtNode** const place = parent == nullptr ? &tree.m_root : &parent->childs[parent->childs[0] == &root ? 0 : 1];
  collect(root);
  *place = build(leaves_, parent);
}

btDbvtNode* TreeBalance::build(std::span<btDbvtNode*> leaves, btDbvtNode* parent) {
  if (leaves.size() == 1) {
    leaves.front()->parent = parent;
    return leaves.front();
  }
  const auto middle = leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2);
  const int axis = longestAxis(leaves);
  std::ranges::nth_element(leaves, middle, {}, [axis](const btDbvtNode* leaf) { return leaf->volume.Center()[axis]; });
  btDbvtNode* const node = inner_.back();
  inner_.pop_back();
  node->parent = parent;
  node->childs[0] = build({leaves.begin(), middle}, node);
  node->childs[1] = build({middle, leaves.end()}, node);
  Merge(node->childs[0]->volume, node->childs[1]->volume, node->volume);
  return node;
}

}  // namespace pongsim::physics
