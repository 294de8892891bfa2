#include "physics/solving/row_ends.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace pongsim::physics {
namespace {

/// Ends at one body of rows with these places.
std::vector<RowEnd> endsAt(const std::vector<int>& places) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<RowEnd> ends;
  for (std::size_t i = 0; i < places.size(); ++i) {
    RowEnd end{};
    for (double& each : end.jacobian) each = number(random);
    for (double& each : end.response) each = number(random);
    end.row = static_cast<int>(i);
    end.before = static_cast<int>(i) - 1;
    end.place = places[i];
    ends.push_back(end);
  }
  return ends;
}

void expectSameAsOneByOne(const std::vector<int>& places) {
  constexpr std::size_t kRows = 24;
  const std::vector<RowEnd> ends = endsAt(places);
  std::vector<double> together(kRows * kRows), oneByOne(kRows * kRows);
  // what another body has added before
  for (std::size_t i = 0; i < together.size(); ++i) together[i] = oneByOne[i] = 0.1 * static_cast<double>(i % 7);
  BodyCoupling().couple(ends, static_cast<int>(ends.size()) - 1, {together.data(), kRows, kRows});
  for (const RowEnd& end : ends) coupleBefore(ends, end, {oneByOne.data(), kRows, kRows});
  for (std::size_t row = 0; row < kRows; ++row) {
    for (std::size_t column = row; column < kRows; ++column) {
      EXPECT_EQ(together[row * kRows + column], oneByOne[row * kRows + column]) << row << ", " << column;
    }
  }
}

TEST(RowEnds, AreCoupledByWhatAnImpulseAlongOneGivesAlongTheOther) {
  RowEnd push{{1, 0, 0, 0, 0, 0}, {0.5, 0, 0, 0, 0, 0}, 0, 0, -1, 0};
  RowEnd slanted{{0.6, 0.8, 0, 0, 0, 2}, {0.3, 0.4, 0, 0, 0, 1}, 1, 0, 0, 1};
  std::vector<double> A(2 * 4);
  BodyCoupling().couple(std::vector{push, slanted}, 1, {A.data(), 4, 2});
  EXPECT_DOUBLE_EQ(A[0], 0.5);
  EXPECT_DOUBLE_EQ(A[1], 0.3);
  EXPECT_DOUBLE_EQ(A[5], 0.18 + 0.32 + 2);
}

TEST(RowEnds, OfABodyTogetherHaveTheBitsOfOneByOne) {
  for (int count = 0; count <= 13; ++count) {
    std::vector<int> places;
    for (int i = 0; i < count; ++i) places.push_back(3 + i);
    expectSameAsOneByOne(places);
  }
}

TEST(RowEnds, HaveTheSameBitsWhereverTheirRowsStand) {
  expectSameAsOneByOne({0, 1, 2, 3, 4, 9, 12, 13, 17});
  expectSameAsOneByOne({15, 0, 1, 2, 3, 4, 16, 5, 6, 7});
  expectSameAsOneByOne({9, 8, 7, 6, 5, 4, 3, 2, 1, 0});
}

TEST(RowEnds, OfOneRowAtOneBodyCountBothWays) {
  const RowEnd first{{1, 0, 0, 0, 0, 0}, {0.5, 0, 0, 0, 0, 0}, 0, 0, -1, 0};
  const RowEnd second{{2, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0}, 0, 0, 0, 0};
  const std::vector<RowEnd> ends{first, second};
  std::vector<double> A(4);
  for (const RowEnd& end : ends) coupleBefore(ends, end, {A.data(), 4, 1});
  // (1 + 2) (0.5 + 1)
  EXPECT_DOUBLE_EQ(A[0], 4.5);
}

TEST(RowEnds, AreAddedManyTimes) {
  std::array<double, 6> sum{1, 2, 3, 4, 5, 6};
  addTimes(sum, {1, 0, -1, 2, 0, 0.5}, 2);
  EXPECT_EQ(sum, (std::array<double, 6>{3, 2, 1, 8, 5, 7}));
}

}  // namespace
}  // namespace pongsim::physics
