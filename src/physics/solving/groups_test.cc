#include "physics/solving/groups.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pongsim::physics {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers all(std::span<const std::uint32_t> members) { return {members.begin(), members.end()}; }

TEST(Groups, HoldWhatTouchesAndWhatJointsConnect) {
  Groups groups;
  const std::vector<Groups::Ends> touches = {{4, 1}, {3, kNoMember}, {kNoMember, 0}};
  const std::vector<Groups::Ends> joints = {{kNoMember, 3}, {4, 5}, {2, kNoMember}};
  groups.form(6, touches, joints);
  ASSERT_EQ(groups.count(), 4U);
  EXPECT_EQ(all(groups.bodies(0)), Numbers{0});
  EXPECT_EQ(all(groups.bodies(1)), (Numbers{1, 4, 5}));
  EXPECT_EQ(all(groups.bodies(2)), Numbers{2});
  EXPECT_EQ(all(groups.bodies(3)), Numbers{3});
  EXPECT_EQ(all(groups.touches(0)), Numbers{2});
  EXPECT_EQ(all(groups.touches(1)), Numbers{0});
  EXPECT_EQ(all(groups.touches(2)), Numbers{});
  EXPECT_EQ(all(groups.touches(3)), Numbers{1});
  EXPECT_EQ(all(groups.joints(0)), Numbers{});
  EXPECT_EQ(all(groups.joints(1)), Numbers{1});
  EXPECT_EQ(all(groups.joints(2)), Numbers{2});
  EXPECT_EQ(all(groups.joints(3)), Numbers{0});
}

TEST(Groups, DoNotDependOnWhatWasFoundFirst) {
  // two chains of ten bodies each, whose links are found in any order
  std::vector<Groups::Ends> links;
  for (int i = 0; i < 18; ++i) links.emplace_back(i + 2, i);
  Groups groups;
  for (unsigned seed = 1; seed < 50; ++seed) {
    std::vector<Groups::Ends> touches;
    std::vector<Groups::Ends> rest = links;
    for (unsigned number = seed; !rest.empty(); number = number * 1'664'525 + 1'013'904'223) {
      const auto next = rest.begin() + static_cast<std::ptrdiff_t>((number >> 8U) % rest.size());
      touches.push_back(*next);
      rest.erase(next);
    }
    groups.form(20, touches, {});
    ASSERT_EQ(groups.count(), 2U);
    for (const std::size_t group : {0U, 1U}) {
      ASSERT_EQ(groups.bodies(group).size(), 10U);
      for (std::uint32_t i = 0; i < 10; ++i) ASSERT_EQ(groups.bodies(group)[i], 2 * i + group);
      ASSERT_EQ(groups.touches(group).size(), 9U);
      EXPECT_TRUE(std::ranges::is_sorted(groups.touches(group)));
      EXPECT_TRUE(std::ranges::all_of(groups.touches(group), [&](std::uint32_t touch) {
        return touches[touch].first % 2 == static_cast<int>(group);
      }));
    }
  }
}

TEST(Groups, AreNoneWithoutBodies) {
  Groups groups;
  EXPECT_EQ(groups.count(), 0U);
  groups.form(0, {}, {});
  EXPECT_EQ(groups.count(), 0U);
}

}  // namespace
}  // namespace pongsim::physics
