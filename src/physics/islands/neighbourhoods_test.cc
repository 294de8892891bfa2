#include "physics/islands/neighbourhoods.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pongsim::physics {
namespace {

using Members = std::vector<std::uint32_t>;

Members listed(std::span<const std::uint32_t> members) { return {members.begin(), members.end()}; }

/// @return Pairs that connect bodies from `first` on in a row, and one of each with something that does not move.
std::vector<Islands::Ends> rowOf(int first, int bodies) {
  std::vector<Islands::Ends> pairs;
  for (int i = 0; i < bodies; ++i) {
    pairs.emplace_back(kNoMember, first + i);
    if (i > 0) pairs.emplace_back(first + i - 1, first + i);
  }
  return pairs;
}

TEST(Neighbourhoods, AreConnectedByPairsAndByJoints) {
  Neighbourhoods neighbourhoods;
  const std::vector<Islands::Ends> pairs = {{kNoMember, 0}, {3, 1}, {kNoMember, 4}};
  const std::vector<Islands::Ends> joints = {{4, 3}, {kNoMember, 2}};
  // as many batches as can be: one for each
  neighbourhoods.form(5, pairs, joints, 100);
  ASSERT_EQ(neighbourhoods.batchCount(), 3U);
  EXPECT_EQ(listed(neighbourhoods.batch(0).bodies), Members{0});
  EXPECT_EQ(listed(neighbourhoods.batch(0).pairs), Members{0});
  EXPECT_EQ(listed(neighbourhoods.batch(1).bodies), (Members{1, 3, 4}));
  EXPECT_EQ(listed(neighbourhoods.batch(1).pairs), (Members{1, 2}));
  EXPECT_EQ(listed(neighbourhoods.batch(1).joints), Members{0});
  EXPECT_EQ(listed(neighbourhoods.batch(2).bodies), Members{2});
  EXPECT_EQ(listed(neighbourhoods.batch(2).joints), Members{1});
  EXPECT_TRUE(neighbourhoods.crowds().bodies.empty());
  EXPECT_EQ(neighbourhoods.placesOf(joints[0]), Islands::Ends(2, 1));
  EXPECT_EQ(neighbourhoods.placesOf(joints[1]), Islands::Ends(kNoMember, 0));
}

TEST(Neighbourhoods, WithManyPairsAreCrowdsThatAreKeptTogether) {
  // a row of 32 bodies has 63 pairs, one of 33 has 65
  std::vector<Islands::Ends> pairs = rowOf(0, 33);
  for (const int first : {33, 65}) {
    const std::vector<Islands::Ends> more = rowOf(first, first == 33 ? 32 : 40);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  const std::vector<Islands::Ends> joints = {{40, 41}, {70, 72}};
  Neighbourhoods neighbourhoods;
  neighbourhoods.form(105, pairs, joints, 1);
  ASSERT_EQ(neighbourhoods.batchCount(), 1U);
  EXPECT_EQ(neighbourhoods.batch(0).bodies.front(), 33U);
  EXPECT_EQ(neighbourhoods.batch(0).pairs.size(), 63U);
  EXPECT_EQ(neighbourhoods.placesOf(joints[0]), Islands::Ends(7, 8));
  const Neighbourhoods::Members crowds = neighbourhoods.crowds();
  EXPECT_EQ(crowds.bodies.size(), 73U);
  EXPECT_EQ(crowds.pairs.size(), 65U + 79U);
  EXPECT_EQ(listed(crowds.joints), Members{1});
  // their places are those among all of the crowds
  EXPECT_EQ(neighbourhoods.placesOf(joints[1]), Islands::Ends(33 + 5, 33 + 7));
  EXPECT_EQ(crowds.bodies[38], 70U);
}

TEST(Neighbourhoods, ComeInBatchesOfAboutTheSameSizeThatAreNotTooLarge) {
  // a hundred bodies alone, and one neighbourhood as large as twenty of them
  std::vector<Islands::Ends> pairs;
  for (int i = 0; i < 100; ++i) pairs.emplace_back(kNoMember, i);
  const std::vector<Islands::Ends> more = rowOf(100, 14);
  pairs.insert(pairs.end(), more.begin(), more.end());
  Neighbourhoods neighbourhoods;
  const auto sizeOf = [&](std::size_t batch) {
    return neighbourhoods.batch(batch).bodies.size() + neighbourhoods.batch(batch).pairs.size();
  };
  neighbourhoods.form(114, pairs, {}, 6);
  Members bodies;
  for (std::size_t i = 0; i < neighbourhoods.batchCount(); ++i) {
    const Members found = listed(neighbourhoods.batch(i).bodies);
    bodies.insert(bodies.end(), found.begin(), found.end());
    EXPECT_LE(sizeOf(i), 40U + 41U);
  }
  EXPECT_EQ(neighbourhoods.batchCount(), 6U);
  ASSERT_EQ(bodies.size(), 114U);
  for (std::uint32_t i = 0; i < 114; ++i) EXPECT_EQ(bodies[i], i);

  neighbourhoods.form(114, pairs, {}, 1);
  EXPECT_EQ(neighbourhoods.batchCount(), 2U);
  EXPECT_EQ(sizeOf(0), Neighbourhoods::kFullBatch);
}

TEST(Neighbourhoods, AreNoneWithoutBodies) {
  Neighbourhoods neighbourhoods;
  EXPECT_EQ(neighbourhoods.batchCount(), 0U);
  EXPECT_TRUE(neighbourhoods.crowds().pairs.empty());
  neighbourhoods.form(0, {}, {}, 64);
  EXPECT_EQ(neighbourhoods.batchCount(), 0U);
  EXPECT_TRUE(neighbourhoods.crowds().bodies.empty());
}

}  // namespace
}  // namespace pongsim::physics
