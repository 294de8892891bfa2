#include "physics/solving/joint_tree.hh"

#include <gtest/gtest.h>

#include <vector>

namespace pongsim::physics {
namespace {

using Joints = std::vector<JointBodies>;

/// Each joint holds its body to the one before it, the first one to the world.
Joints chainOf(int links) {
  Joints joints;
  for (int i = 0; i < links; ++i) joints.push_back({i - 1, i});
  return joints;
}

JointTree treeOf(const Joints& joints) {
  JointTree tree;
  tree.find(joints);
  return tree;
}

TEST(JointTree, GrowsFromTheWorldWhereItIsHeldThere) {
  const JointTree tree = treeOf({{1, 0}, {1, 2}, {2, -1}});
  ASSERT_EQ(tree.links().size(), 3U);
  EXPECT_EQ(tree.links()[0].body, 2);
  EXPECT_EQ(tree.links()[0].parent, -1);
  EXPECT_TRUE(tree.links()[0].isReversed);
  EXPECT_EQ(tree.links()[1].body, 1);
  EXPECT_TRUE(tree.links()[1].isReversed);
  EXPECT_EQ(tree.links()[2].body, 0);
  EXPECT_FALSE(tree.links()[2].isReversed);
  for (const int body : {0, 1, 2}) EXPECT_EQ(tree.linkOf(body), 2 - body);
}

TEST(JointTree, GrowsFromTheFirstBodyElsewhere) {
  const JointTree tree = treeOf({{3, 4}, {2, 1}, {4, 5}});
  ASSERT_EQ(tree.links().size(), 3U);
  for (const int root : {0, 1, 3, 6}) EXPECT_EQ(tree.linkOf(root), -1) << root;
  for (const JointTree::Link& link : tree.links()) {
    EXPECT_LT(tree.linkOf(link.parent), tree.linkOf(link.body));
    EXPECT_EQ(tree.linkOfJoint(static_cast<std::size_t>(link.joint)), tree.linkOf(link.body));
  }
}

TEST(JointTree, LeavesOutJointsThatCloseLoopsOrHoldNothing) {
  // a ring, a second joint to the world, a joint of a body with itself, and a gearbox
  const JointTree tree = treeOf({{-1, 0}, {0, 1}, {1, 2}, {2, 0}, {-1, 2}, {1, 1}, {1, 2, 0, false}});
  EXPECT_EQ(tree.links().size(), 3U);
  int left = 0;
  for (std::size_t joint = 0; joint < 7; ++joint) left += tree.linkOfJoint(joint) < 0 ? 1 : 0;
  EXPECT_EQ(left, 4);
  EXPECT_EQ(tree.linkOfJoint(6), -1);
}

TEST(JointTree, IsDeepWhereJointsHangTogetherOverOthers) {
  EXPECT_FALSE(treeOf({{0, 1}, {1, 2}}).isDeep());
  EXPECT_TRUE(treeOf({{0, 1}, {1, 2}, {2, 3}}).isDeep());
  // two robots with three wheels each
  EXPECT_FALSE(treeOf({{0, 1}, {0, 2}, {0, 3}, {4, 5}, {4, 6}, {4, 7}}).isDeep());
  // a gearbox acts on all of its bodies
  EXPECT_FALSE(treeOf({{0, 1}, {0, 2}, {1, 2, 0, false}}).isDeep());
  EXPECT_TRUE(treeOf({{0, 1}, {0, 2}, {1, 2, 0, false}, {2, 3}}).isDeep());
}

TEST(JointTree, SeesAHub) {
  EXPECT_TRUE(haveOneHub(Joints{}));
  EXPECT_TRUE(haveOneHub(Joints{{0, 1}, {2, 0}, {-1, 0}}));
  EXPECT_FALSE(haveOneHub(Joints{{0, 1}, {1, 2}, {2, 3}}));
  // the world is none
  EXPECT_FALSE(haveOneHub(Joints{{-1, 0}, {-1, 1}}));
}

TEST(JointTrees, FindTheTreesOfEachIslandAgain) {
  JointTrees trees;
  const Joints one = chainOf(5);
  EXPECT_TRUE(trees.find(one).isOf(one));
  // more of them than are kept
  for (int links = 1; links < 200; ++links) EXPECT_TRUE(trees.find(chainOf(links)).isOf(chainOf(links)));
  EXPECT_TRUE(trees.find(one).isOf(one));
  Joints gear = one;
  gear.back().holds = false;
  EXPECT_FALSE(trees.find(gear).isOf(one));
}

}  // namespace
}  // namespace pongsim::physics
