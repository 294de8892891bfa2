#include "sdf/frames/frame_graph.hh"

#include <gtest/gtest.h>

namespace pongsim::sdf {
namespace {

using Nodes = std::vector<std::size_t>;

TEST(FrameGraph, PutsEachNodeBehindTheOneItFollows) {
  const FrameOrder order = orderFrames(Nodes{kNoNode, 3, 1, 0});
  EXPECT_EQ(order.order, (Nodes{0, 3, 1, 2}));
  EXPECT_TRUE(order.cycles.empty());
}

TEST(FrameGraph, FindsEachCycleOnce) {
  const FrameOrder order = orderFrames(Nodes{kNoNode, 4, 2, 1, 3, 0});
  EXPECT_EQ(order.cycles, (std::vector<Nodes>{{1, 4, 3}, {2}}));
  EXPECT_EQ(order.order, (Nodes{0, 5}));
}

TEST(FrameGraph, LeavesOutWhatLeadsIntoACycle) {
  const FrameOrder order = orderFrames(Nodes{1, 2, 2});
  EXPECT_EQ(order.cycles, (std::vector<Nodes>{{2}}));
  EXPECT_TRUE(order.order.empty());
}

TEST(FrameGraph, FollowsLongChains) {
  Nodes next(100'000);
  for (std::size_t i = 0; i + 1 < next.size(); ++i) next[i] = i + 1;
  next.back() = kNoNode;
  const FrameOrder order = orderFrames(next);
  ASSERT_EQ(order.order.size(), next.size());
  EXPECT_EQ(order.order.front(), next.size() - 1);
}

}  // namespace
}  // namespace pongsim::sdf
