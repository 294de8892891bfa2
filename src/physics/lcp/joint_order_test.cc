#include "physics/lcp/joint_order.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

/// Each joint holds its body to the one before it, the first one to the world.
std::vector<JointBodies> chainOf(int links) {
  std::vector<JointBodies> joints;
  for (int i = 0; i < links; ++i) joints.push_back({i - 1, i, -1});
  return joints;
}

std::size_t countCoupled(const JointOrder& order) {
  std::size_t count = 0;
  for (std::size_t place = 0; place < order.count(); ++place) count += order.later(static_cast<int>(place)).size();
  return count;
}

TEST(JointOrder, CouplesNeighboursAloneInAChain) {
  JointOrder order;
  order.find(chainOf(50));
  EXPECT_EQ(countCoupled(order), 49U);
  EXPECT_TRUE(order.isDeep());
}

TEST(JointOrder, CouplesNoMoreInATreeThanActsOnABody) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    std::vector<JointBodies> joints;
    std::vector<std::size_t> at(31, 0);
    for (int child = 1; child <= 30; ++child) {
      const int parent = static_cast<int>(random() % static_cast<unsigned>(child));
      joints.push_back({parent, child, -1});
      ++at[static_cast<std::size_t>(parent)];
      ++at[static_cast<std::size_t>(child)];
    }
    std::size_t pairs = 0;
    for (const std::size_t count : at) pairs += count * (count - (count > 0 ? 1 : 0)) / 2;
    JointOrder order;
    order.find(joints);
    EXPECT_EQ(countCoupled(order), pairs);
  }
}

TEST(JointOrder, HasAllThatAnEliminatedJointCouplesBehindIt) {
  // rings on rings
  std::vector<JointBodies> joints;
  for (int i = 0; i < 20; ++i) {
    joints.push_back({i, (i + 1) % 20, -1});
    joints.push_back({i, 20 + i, -1});
    joints.push_back({20 + i, (i + 3) % 20, -1});
  }
  JointOrder order;
  order.find(joints);
  for (int place = 0; place < static_cast<int>(order.count()); ++place) {
    EXPECT_EQ(order.placeOf(order.jointAt(place)), place);
    const auto later = order.later(place);
    ASSERT_TRUE(std::ranges::is_sorted(later));
    if (later.empty()) continue;
    EXPECT_GT(later.front(), place);
    // the first of them is coupled with all others
    for (const int other : later.subspan(1)) {
      EXPECT_TRUE(std::ranges::binary_search(order.later(later.front()), other)) << place << ", " << other;
    }
  }
}

TEST(JointOrder, KnowsTheFirstJointAtABody) {
  JointOrder order;
  order.find(std::vector<JointBodies>{{0, 1, -1}, {1, 2, 4}, {2, 3, -1}});
  for (const int body : {0, 1, 2, 3, 4}) EXPECT_GE(order.firstAt(body), 0) << body;
  EXPECT_EQ(order.firstAt(4), order.placeOf(1));
  EXPECT_EQ(order.firstAt(5), -1);
}

TEST(JointOrder, IsDeepWhereJointsHangTogetherOverOthers) {
  const auto isDeep = [](const std::vector<JointBodies>& joints) {
    JointOrder order;
    order.find(joints);
    return order.isDeep();
  };
  EXPECT_FALSE(isDeep({{0, 1, -1}, {1, 2, -1}}));
  EXPECT_TRUE(isDeep({{0, 1, -1}, {1, 2, -1}, {2, 3, -1}}));
  // two robots with three wheels each
  EXPECT_FALSE(isDeep({{0, 1, -1}, {0, 2, -1}, {0, 3, -1}, {4, 5, -1}, {4, 6, -1}, {4, 7, -1}}));
}

TEST(JointOrder, SeesAHub) {
  EXPECT_TRUE(haveOneHub(std::vector<JointBodies>{}));
  EXPECT_TRUE(haveOneHub(std::vector<JointBodies>{{0, 1, -1}, {2, 0, -1}, {-1, 0, -1}}));
  EXPECT_FALSE(haveOneHub(std::vector<JointBodies>{{0, 1, -1}, {1, 2, -1}, {2, 3, -1}}));
  // the world is none
  EXPECT_FALSE(haveOneHub(std::vector<JointBodies>{{-1, 0, -1}, {-1, 1, -1}}));
}

TEST(JointOrders, FindTheOrderOfEachGroupAgain) {
  JointOrders orders;
  const std::vector<JointBodies> one = chainOf(5);
  const JointOrder& found = orders.find(one);
  EXPECT_TRUE(found.isOf(one));
  // more of them than are kept
  for (int links = 1; links < 200; ++links) EXPECT_TRUE(orders.find(chainOf(links)).isOf(chainOf(links)));
  EXPECT_TRUE(orders.find(one).isOf(one));
}

}  // namespace
}  // namespace pongsim::physics
