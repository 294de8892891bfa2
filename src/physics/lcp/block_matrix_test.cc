#include "physics/lcp/block_matrix.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "support/physics/tree_case.hh"

namespace pongsim::physics {
namespace {

using test::TreeCase;

TEST(BlockMatrix, SolvesTreesAndLoops) {
  std::mt19937 random(1);
  BlockMatrix matrix;
  for (int i = 0; i < 60; ++i) {
    const TreeCase which(random, 2 + i % 15, i % 4, 0);
    const auto [isTaken, indices] = which.writeTo(matrix);
    ASSERT_TRUE(isTaken);
    ASSERT_TRUE(matrix.eliminate());
    std::vector<double> x(matrix.size(), 0.0);
    for (const int side : {0, 1}) {
      matrix.substitute(side, x.data());
      for (std::size_t row = 0; row < which.rows.size(); ++row) {
        double sum = 0;
        for (std::size_t k = 0; k < which.rows.size(); ++k)
          sum += which.A(row, k) * x[static_cast<std::size_t>(indices[k])];
        EXPECT_NEAR(sum, side == 0 ? which.b[row] : which.b2[row], 1e-8) << "case " << i << ", row " << row;
      }
    }
  }
}

TEST(BlockMatrix, TakesWorkInProportionToTheLengthOfAChain) {
  const auto workOf = [](int links) {
    std::vector<JointBodies> joints;
    for (int i = 0; i < links; ++i) joints.push_back({i - 1, i, -1});
    JointOrder order;
    order.find(joints);
    BlockMatrix matrix;
    EXPECT_TRUE(matrix.begin(order, std::vector<int>(joints.size(), 5), 0, {}));
    return matrix.work();
  };
  EXPECT_NEAR(workOf(1000) / workOf(100), 10, 0.1);
}

TEST(BlockMatrix, RefusesWhatIsNotPositiveDefiniteOrTooLarge) {
  const std::vector<JointBodies> joints = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}};
  JointOrder order;
  order.find(joints);
  BlockMatrix matrix;
  ASSERT_TRUE(matrix.begin(order, std::vector<int>{1, 1, 1}, 0, {}));
  for (int place = 0; place < 3; ++place) *matrix.block(place, place).data = 1;
  *matrix.block(0, 1).data = 2;
  EXPECT_FALSE(matrix.eliminate());
  EXPECT_FALSE(matrix.begin(order, std::vector<int>{1, BlockMatrix::kMostBlockRows + 1, 1}, 0, {}));
}

}  // namespace
}  // namespace pongsim::physics
