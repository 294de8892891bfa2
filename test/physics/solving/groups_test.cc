#include "physics/solving/groups.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pongsim::physics {
namespace {

Touch touchOf(int a, int b) { return {static_cast<std::uint64_t>(10 * a + b), 0, nullptr, a, b}; }

std::vector<std::uint32_t> all(std::span<const std::uint32_t> members) { return {members.begin(), members.end()}; }

using Numbers = std::vector<std::uint32_t>;

TEST(Groups, HoldWhatTouchesAndWhatJointsConnect) {
  Groups groups;
  const std::vector<FoundTouches> touches = {{{touchOf(4, 1)}}, {{touchOf(3, kNoMember), touchOf(kNoMember, 0)}}};
  const std::vector<Groups::Ends> joints = {{kNoMember, 3}, {4, 5}, {2, kNoMember}};
  groups.form(6, touches, joints);
  ASSERT_EQ(groups.count(), 4U);
  EXPECT_EQ(all(groups.bodies(0)), Numbers{0});
  EXPECT_EQ(all(groups.bodies(1)), (Numbers{1, 4, 5}));
  EXPECT_EQ(all(groups.bodies(2)), Numbers{2});
  EXPECT_EQ(all(groups.bodies(3)), Numbers{3});
  EXPECT_EQ(all(groups.joints(1)), Numbers{1});
  EXPECT_EQ(all(groups.joints(2)), Numbers{2});
  EXPECT_EQ(all(groups.joints(3)), Numbers{0});
  ASSERT_EQ(groups.touches(1).size(), 1U);
  EXPECT_EQ(groups.touches(1)[0].links, 41U);
  EXPECT_EQ(groups.touches(3).size(), 1U);
  EXPECT_TRUE(groups.touches(2).empty());
}

TEST(Groups, DoNotDependOnWhoFoundWhatFirst) {
  // two chains of ten bodies each, whose links are found in any order, by any of three
  std::vector<Touch> links;
  for (int i = 0; i < 18; ++i) links.push_back(touchOf(i + 2, i));
  Groups groups;
  for (unsigned seed = 1; seed < 50; ++seed) {
    std::vector<FoundTouches> touches(3);
    std::vector<Touch> rest = links;
    for (unsigned number = seed; !rest.empty(); number = number * 1'664'525 + 1'013'904'223) {
      const auto next = rest.begin() + static_cast<std::ptrdiff_t>((number >> 8U) % rest.size());
      touches[(number >> 4U) % 3].list.push_back(*next);
      rest.erase(next);
    }
    groups.form(20, touches, {});
    ASSERT_EQ(groups.count(), 2U);
    for (const std::size_t group : {0U, 1U}) {
      ASSERT_EQ(groups.bodies(group).size(), 10U);
      for (std::uint32_t i = 0; i < 10; ++i) ASSERT_EQ(groups.bodies(group)[i], 2 * i + group);
      ASSERT_EQ(groups.touches(group).size(), 9U);
      EXPECT_TRUE(std::ranges::all_of(groups.touches(group),
                                      [&](const Touch& touch) { return touch.a % 2 == static_cast<int>(group); }));
    }
  }
}

TEST(Groups, AreNoneWithoutBodies) {
  Groups groups;
  groups.form(0, {}, {});
  EXPECT_EQ(groups.count(), 0U);
}

}  // namespace
}  // namespace pongsim::physics
