#include "physics/contacts/tree_balance.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

btDbvtVolume boxAt(double x, double y = 0, double z = 0) {
  return btDbvtVolume::FromMM(btVector3(x, y, z), btVector3(x + 0.5, y + 0.5, z + 0.5));
}

/// A tree that is kept shallow. Leaves are known by their numbers.
class Tree {
 public:
  void insert(const btDbvtVolume& box) {
    leaves_.push_back(tree_.insert(box, nullptr));
    leaves_.back()->dataAsInt = static_cast<int>(leaves_.size()) - 1;
    balance_.keepShallow(tree_, *leaves_.back());
    largestDepth_ = std::max(largestDepth_, depthOf(*leaves_.back()));
  }
  void move(std::size_t leaf, btDbvtVolume box) {
    tree_.update(leaves_[leaf], box);
    balance_.keepShallow(tree_, *leaves_[leaf]);
    largestDepth_ = std::max(largestDepth_, depthOf(*leaves_[leaf]));
  }
  /// Removes the last one.
  void remove() {
    tree_.remove(leaves_.back());
    leaves_.pop_back();
  }

  /// @return The largest depth of a leaf just inserted or moved.
  int largestDepth() const { return largestDepth_; }
  int limit() const { return 5 * static_cast<int>(std::bit_width(leaves_.size())) / 2 + 1; }

  void expectWhole() const {
    std::vector<int> found;
    const std::function<void(const btDbvtNode*)> visit = [&](const btDbvtNode* node) {
      if (node->isleaf()) {
        found.push_back(node->dataAsInt);
        ASSERT_EQ(node, leaves_.at(static_cast<std::size_t>(node->dataAsInt)));
        return;
      }
      for (const btDbvtNode* child : node->childs) {
        ASSERT_EQ(child->parent, node);
        ASSERT_TRUE(node->volume.Contain(child->volume));
        visit(child);
      }
    };
    ASSERT_EQ(tree_.m_root->parent, nullptr);
    visit(tree_.m_root);
    std::ranges::sort(found);
    ASSERT_EQ(found.size(), leaves_.size());
    EXPECT_EQ(std::ranges::unique(found).size(), 0U);
  }

 private:
  static int depthOf(const btDbvtNode& leaf) {
    int depth = 0;
    for (const btDbvtNode* node = leaf.parent; node != nullptr; node = node->parent) ++depth;
    return depth;
  }

  btDbvt tree_;
  TreeBalance balance_;
  std::vector<btDbvtNode*> leaves_;
  int largestDepth_ = 0;
};

// Bullet's own tree would be as deep as the row is long.
TEST(TreeBalance, KeepsATreeOfARowShallow) {
  for (const int direction : {1, -1}) {
    Tree tree;
    for (int i = 0; i < 5000; ++i) tree.insert(boxAt(direction * i));
    EXPECT_LE(tree.largestDepth(), tree.limit());
    tree.expectWhole();
  }
}

TEST(TreeBalance, KeepsATreeOfBoxesInOnePlaceShallow) {
  Tree tree;
  for (int i = 0; i < 2000; ++i) tree.insert(boxAt(0));
  EXPECT_LE(tree.largestDepth(), tree.limit());
  tree.expectWhole();
}

TEST(TreeBalance, KeepsATreeShallowWhileBoxesComeMoveAndGo) {
  Tree tree;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 50);
  for (int i = 0; i < 300; ++i) tree.insert(boxAt(i));
  for (int round = 0; round < 20; ++round) {
    // all to the end of the row
    for (std::size_t leaf = 0; leaf < 300; ++leaf)
      tree.move(leaf, boxAt(300.0 * (round + 1) + static_cast<double>(leaf)));
    for (int i = 0; i < 20; ++i) tree.insert(boxAt(place(random), place(random), place(random)));
    tree.expectWhole();
    for (int i = 0; i < 20; ++i) tree.remove();
    tree.expectWhole();
  }
  EXPECT_LE(tree.largestDepth(), tree.limit() + 1);
}

TEST(TreeBalance, LeavesASmallTreeAlone) {
  Tree tree;
  for (int i = 0; i < 4; ++i) {
    tree.insert(boxAt(i));
    tree.expectWhole();
  }
}

}  // namespace
}  // namespace pongsim::physics
