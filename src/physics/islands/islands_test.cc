#include "physics/islands/islands.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pongsim::physics {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers all(std::span<const std::uint32_t> members) { return {members.begin(), members.end()}; }

TEST(Islands, HoldWhatTouchesAndWhatJointsConnect) {
  Islands islands;
  const std::vector<Islands::Ends> touches = {{4, 1}, {3, kNoMember}, {kNoMember, 0}};
  const std::vector<Islands::Ends> joints = {{kNoMember, 3}, {4, 5}, {2, kNoMember}};
  islands.form(6, touches, joints);
  ASSERT_EQ(islands.count(), 4U);
  EXPECT_EQ(all(islands.bodies(0)), Numbers{0});
  EXPECT_EQ(all(islands.bodies(1)), (Numbers{1, 4, 5}));
  EXPECT_EQ(all(islands.bodies(2)), Numbers{2});
  EXPECT_EQ(all(islands.bodies(3)), Numbers{3});
  EXPECT_EQ(all(islands.touches(0)), Numbers{2});
  EXPECT_EQ(all(islands.touches(1)), Numbers{0});
  EXPECT_EQ(all(islands.touches(2)), Numbers{});
  EXPECT_EQ(all(islands.touches(3)), Numbers{1});
  EXPECT_EQ(all(islands.joints(0)), Numbers{});
  EXPECT_EQ(all(islands.joints(1)), Numbers{1});
  EXPECT_EQ(all(islands.joints(2)), Numbers{2});
  EXPECT_EQ(all(islands.joints(3)), Numbers{0});
}

TEST(Islands, DoNotDependOnWhatWasFoundFirst) {
  // two chains of ten bodies each, whose links are found in any order
  std::vector<Islands::Ends> links;
  for (int i = 0; i < 18; ++i) links.emplace_back(i + 2, i);
  Islands islands;
  for (unsigned seed = 1; seed < 50; ++seed) {
    std::vector<Islands::Ends> touches;
    std::vector<Islands::Ends> rest = links;
    for (unsigned number = seed; !rest.empty(); number = number * 1'664'525 + 1'013'904'223) {
      const auto next = rest.begin() + static_cast<std::ptrdiff_t>((number >> 8U) % rest.size());
      touches.push_back(*next);
      rest.erase(next);
    }
    islands.form(20, touches, {});
    ASSERT_EQ(islands.count(), 2U);
    for (const std::size_t island : {0U, 1U}) {
      ASSERT_EQ(islands.bodies(island).size(), 10U);
      for (std::uint32_t i = 0; i < 10; ++i) ASSERT_EQ(islands.bodies(island)[i], 2 * i + island);
      ASSERT_EQ(islands.touches(island).size(), 9U);
      EXPECT_TRUE(std::ranges::is_sorted(islands.touches(island)));
      EXPECT_TRUE(std::ranges::all_of(islands.touches(island), [&](std::uint32_t touch) {
        return touches[touch].first % 2 == static_cast<int>(island);
      }));
    }
  }
}

TEST(Islands, AreNoneWithoutBodies) {
  Islands islands;
  EXPECT_EQ(islands.count(), 0U);
  islands.form(0, {}, {});
  EXPECT_EQ(islands.count(), 0U);
}

}  // namespace
}  // namespace pongsim::physics
